#include "core/session/disk.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

namespace posecoach {
namespace fs = std::filesystem;
namespace {

constexpr mode_t kFileMode = 0644, kFolderMode = 0755;
constexpr std::size_t kBlockBytes = std::size_t{1} << 18;

// Closes on every way out. The last close's answer is of no use after fsync.
class Descriptor {
 public:
  explicit Descriptor(int descriptor) : descriptor_(descriptor) {}
  ~Descriptor() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return descriptor_; }

 private:
  int descriptor_;
};

Result<void> write_all(Disk& disk, int descriptor, std::string_view bytes, const fs::path& path) {
  while (!bytes.empty()) {
    const ssize_t written = disk.write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return tl::unexpected(disk_error("write", path));
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

// Pipes and some network folders cannot be synced, and say so.
bool sync_descriptor(Disk& disk, int descriptor) {
  return disk.fsync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP;
}

Result<void> sync_folder_of(Disk& disk, const fs::path& path) {
  const fs::path parent = path.parent_path();
  return sync(disk, parent.empty() ? fs::path(".") : parent);
}

constexpr std::string_view kTemporary = ".tmp";

// The process that a temporary file belongs to; 0 for other files.
pid_t process_of(const fs::path& path) {
  const std::string name = path.filename().string();
  const std::size_t at = name.rfind(kTemporary);
  if (at == std::string::npos) return 0;
  pid_t process = 0;
  const char* end = name.data() + name.size();
  const auto [stop, error] = std::from_chars(name.data() + at + kTemporary.size(), end, process);
  return error == std::errc{} && stop == end ? process : 0;
}

// What was begun is taken back without touching the reason of the failure.
tl::unexpected<Error> undone(Disk& disk, const fs::path& path, Error error) {
  disk.remove(path.c_str());
  return tl::unexpected(std::move(error));
}

}  // namespace

int Disk::open(const char* path, int flags, mode_t mode) {
  return ::open(path, flags | O_CLOEXEC, mode);
}
ssize_t Disk::write(int descriptor, const void* bytes, std::size_t size) {
  return ::write(descriptor, bytes, size);
}
int Disk::fsync(int descriptor) {
  return ::fsync(descriptor);
}
int Disk::rename(const char* from, const char* to) {
  return ::rename(from, to);
}
int Disk::rename_to_new(const char* from, const char* to) {
  if (::renameat2(AT_FDCWD, from, AT_FDCWD, to, RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS) return -1;
  // A file system without the flag. A folder's rename fails on one that is not empty anyway.
  struct stat ignored = {};
  if (::lstat(to, &ignored) == 0) return errno = EEXIST, -1;
  return ::rename(from, to);
}
int Disk::exchange(const char* a, const char* b) {
  return ::renameat2(AT_FDCWD, a, AT_FDCWD, b, RENAME_EXCHANGE);
}
int Disk::link(const char* from, const char* to) {
  return ::link(from, to);
}
int Disk::make_folder(const char* path) {
  return ::mkdir(path, kFolderMode);
}
int Disk::remove(const char* path) {
  return std::remove(path);
}

Disk& system_disk() {
  static Disk disk;
  return disk;
}

Error disk_error(std::string_view verb, const fs::path& path) {
  const int reason = errno;
  std::string message = "cannot " + std::string(verb) + " " + path.string() + ": " + std::strerror(reason);
  if (reason == ENOSPC || reason == EDQUOT) message += "; make room on the disk and try again";
  return {reason == ENOENT ? ErrorCode::NotFound : ErrorCode::Unreadable, one_line(std::move(message))};
}

Result<void> store_file(Disk& disk, const fs::path& path, std::string_view bytes) {
  const fs::path temporary = path.string() + std::string(kTemporary) + std::to_string(::getpid());
  {
    const Descriptor file(disk.open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC, kFileMode));
    if (file.get() < 0) return tl::unexpected(disk_error("create", path));
    if (const Result<void> written = write_all(disk, file.get(), bytes, path); !written)
      return undone(disk, temporary, written.error());
    if (!sync_descriptor(disk, file.get())) return undone(disk, temporary, disk_error("write", path));
  }
  if (disk.rename(temporary.c_str(), path.c_str()) != 0)
    return undone(disk, temporary, disk_error("write", path));
  return sync_folder_of(disk, path);
}

bool is_temporary(const fs::path& path) {
  return process_of(path) > 0;
}

void remove_dead_temporaries(Disk& disk, const fs::path& folder) {
  std::error_code failed;
  std::vector<fs::path> dead;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed))
    if (const pid_t process = process_of(entry->path());
        process > 0 && ::kill(process, 0) != 0 && errno == ESRCH)
      dead.push_back(entry->path());
  for (const fs::path& path : dead) disk.remove(path.c_str());
}

Result<void> copy_file(Disk& disk, const fs::path& from, const fs::path& to, const Progress& progress) {
  std::error_code failed;
  if (fs::is_directory(from, failed))
    return fail(ErrorCode::Unreadable, from.string() + " is a folder, not a file");
  const Descriptor source(::open(from.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status = {};
  if (source.get() < 0 || ::fstat(source.get(), &status) != 0)
    return tl::unexpected(disk_error("open", from));
  const Descriptor copy(disk.open(to.c_str(), O_WRONLY | O_CREAT | O_EXCL, kFileMode));
  if (copy.get() < 0) return tl::unexpected(disk_error("create", to));
  std::vector<char> block(kBlockBytes);
  for (double done = 0;;) {
    const ssize_t got = ::read(source.get(), block.data(), block.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return undone(disk, to, disk_error("read", from));
    if (got == 0) break;
    const std::string_view bytes(block.data(), static_cast<std::size_t>(got));
    if (const Result<void> written = write_all(disk, copy.get(), bytes, to); !written)
      return undone(disk, to, written.error());
    done += static_cast<double>(got);
    if (!report(progress, "copying",
                std::min(1.0, done / static_cast<double>(std::max<off_t>(1, status.st_size)))))
      return undone(disk, to, {ErrorCode::Cancelled, "stopped; " + from.string() + " was not copied"});
  }
  if (!sync_descriptor(disk, copy.get())) return undone(disk, to, disk_error("write", to));
  return {};
}

Result<void> make_folders(Disk& disk, const fs::path& folder) {
  std::error_code failed;
  if (folder.empty() || fs::is_directory(folder, failed)) return {};
  if (const Result<void> above = make_folders(disk, folder.parent_path()); !above) return above;
  if (disk.make_folder(folder.c_str()) != 0 && errno != EEXIST)
    return tl::unexpected(disk_error("make the folder", folder));
  if (!fs::is_directory(folder, failed))
    return fail(ErrorCode::Unreadable, folder.string() + " is in the way: a folder belongs there");
  return sync_folder_of(disk, folder);
}

Result<void> sync(Disk& disk, const fs::path& path) {
  const Descriptor file(disk.open(path.c_str(), O_RDONLY, 0));
  if (file.get() < 0) return tl::unexpected(disk_error("open", path));
  if (!sync_descriptor(disk, file.get())) return tl::unexpected(disk_error("write", path));
  return {};
}

Result<void> remove_folder(Disk& disk, const fs::path& folder) {
  std::error_code failed;
  std::vector<fs::path> inside;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed))
    inside.push_back(entry->path());
  if (failed) return fail(ErrorCode::Unreadable, "cannot read " + folder.string() + ": " + failed.message());
  for (const fs::path& path : inside) {
    const fs::file_status status = fs::symlink_status(path, failed);
    if (fs::is_directory(status)) {
      if (const Result<void> removed = remove_folder(disk, path); !removed) return removed;
    } else if (disk.remove(path.c_str()) != 0) {
      return tl::unexpected(disk_error("remove", path));
    }
  }
  if (disk.remove(folder.c_str()) != 0) return tl::unexpected(disk_error("remove", folder));
  return {};
}

}  // namespace posecoach
