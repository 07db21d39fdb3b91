// A file written piece by piece that appears under its name only when it is complete.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace posecoach {

// A device, a pipe or a socket: whatever is renamed to its name would destroy it.
bool is_special_file(const std::filesystem::path& path);

// Where a renamed file has to arrive so that symbolic links on the way stay links: /dev/stdout, for one.
std::filesystem::path behind_links(const std::filesystem::path& path);

class AtomicFile {
 public:
  // The name "-" is standard output, which cannot be taken back; nor can what goes to a device or a pipe.
  // Errors: Unreadable, NotFound (no such folder).
  static Result<AtomicFile> create(const std::filesystem::path& name);
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&& other) noexcept;
  // Without commit() nothing is left behind.
  ~AtomicFile();

  Result<void> write(std::string_view bytes);
  // Syncs and renames; afterwards the file is there, whole.
  Result<void> commit();

 private:
  AtomicFile(int descriptor, std::filesystem::path path, std::filesystem::path temporary);
  void abandon();

  int descriptor_ = -1;
  std::filesystem::path path_;
  std::filesystem::path temporary_;  // empty where nothing is to be renamed
  std::string buffer_;
};

}  // namespace posecoach
