// The few system calls by which the library changes the disk, and whole files made of them. Tests put a full
// disk, or a death at any call, behind it.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string_view>

#include "core/base/error.h"
#include "core/base/progress.h"

namespace posecoach {

// As the system calls of these names: a negative answer leaves the reason in errno.
class Disk {
 public:
  virtual ~Disk() = default;
  virtual int open(const char* path, int flags, mode_t mode);
  virtual ssize_t write(int descriptor, const void* bytes, std::size_t size);
  virtual int fsync(int descriptor);
  virtual int rename(const char* from, const char* to);
  // Fails with EEXIST rather than take the place of what is there.
  virtual int rename_to_new(const char* from, const char* to);
  // Fails with EINVAL or ENOSYS where the file system cannot.
  virtual int exchange(const char* a, const char* b);
  virtual int link(const char* from, const char* to);
  virtual int make_folder(const char* path);
  virtual int remove(const char* path);  // a file or an empty folder
};

Disk& system_disk();

// One line: "cannot VERB PATH: reason", with advice where the disk is full. Reads errno.
Error disk_error(std::string_view verb, const std::filesystem::path& path);

// Old or new, never half; on the disk when it returns.
Result<void> store_file(Disk& disk, const std::filesystem::path& path, std::string_view bytes);
// A name that store_file uses on the way; `.tmpPID` at its end.
bool is_temporary(const std::filesystem::path& path);
// Those in a folder whose process died before the rename.
void remove_dead_temporaries(Disk& disk, const std::filesystem::path& folder);
// Into a file that is not there yet; on failure it is gone again. Errors: NotFound, Unreadable, Cancelled.
Result<void> copy_file(Disk& disk, const std::filesystem::path& from, const std::filesystem::path& to,
                       const Progress& progress = {});
// The folder and those above it; no error where they are.
Result<void> make_folders(Disk& disk, const std::filesystem::path& folder);
// Brings what was written by whomever onto the disk: a file, or the names in a folder.
Result<void> sync(Disk& disk, const std::filesystem::path& path);
// With everything in it; does not follow links.
Result<void> remove_folder(Disk& disk, const std::filesystem::path& folder);

}  // namespace posecoach
