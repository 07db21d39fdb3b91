// SHA-256 (FIPS 180-4), as `sha256sum` prints it: so that anybody can check a swing's files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/progress.h"

struct AVSHA;

namespace posecoach {

class Sha256 {
 public:
  Sha256();
  void add(std::string_view bytes);
  // 64 hexadecimal digits; nothing may be added afterwards.
  std::string finish();

 private:
  struct Free {
    void operator()(AVSHA* state) const;
  };
  std::unique_ptr<AVSHA, Free> state_;
};

struct FileDigest {
  std::uint64_t bytes = 0;
  std::string sha256;
};
// Errors: NotFound, Unreadable, Cancelled.
Result<FileDigest> digest_file(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace posecoach
