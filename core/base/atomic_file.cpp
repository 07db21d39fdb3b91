#include "core/base/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <utility>

#include "core/base/system_error.h"

namespace posecoach {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 18;

Result<void> write_all(int descriptor, std::string_view bytes, const fs::path& path) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return tl::unexpected(system_error("cannot write", path));
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

}  // namespace

bool is_special_file(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

fs::path behind_links(const fs::path& path) {
  std::error_code failed;
  if (!fs::is_symlink(path, failed)) return path;
  fs::path target = fs::weakly_canonical(path, failed);
  return failed ? path : target;
}

Result<AtomicFile> AtomicFile::create(const fs::path& name) {
  if (name == "-") return AtomicFile(STDOUT_FILENO, "standard output", {});
  if (is_special_file(name)) {
    const int descriptor = ::open(name.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) return tl::unexpected(system_error("cannot open", name));
    return AtomicFile(descriptor, name, {});
  }
  const fs::path path = behind_links(name);
  fs::path temporary = path.string() + ".tmp" + std::to_string(::getpid());
  const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) return tl::unexpected(system_error("cannot create", path));
  return AtomicFile(descriptor, path, std::move(temporary));
}

AtomicFile::AtomicFile(int descriptor, fs::path path, fs::path temporary)
    : descriptor_(descriptor), path_(std::move(path)), temporary_(std::move(temporary)) {}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      path_(std::move(other.path_)),
      temporary_(std::move(other.temporary_)),
      buffer_(std::move(other.buffer_)) {}

AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept {
  if (this == &other) return *this;
  abandon();
  descriptor_ = std::exchange(other.descriptor_, -1);
  path_ = std::move(other.path_);
  temporary_ = std::move(other.temporary_);
  buffer_ = std::move(other.buffer_);
  return *this;
}

AtomicFile::~AtomicFile() {
  abandon();
}

void AtomicFile::abandon() {
  if (descriptor_ >= 0 && descriptor_ != STDOUT_FILENO) ::close(descriptor_);
  if (descriptor_ >= 0 && !temporary_.empty()) ::unlink(temporary_.c_str());
  descriptor_ = -1;
}

Result<void> AtomicFile::write(std::string_view bytes) {
  buffer_ += bytes;
  if (buffer_.size() < kBufferBytes) return {};
  const Result<void> written = write_all(descriptor_, buffer_, path_);
  buffer_.clear();
  return written;
}

Result<void> AtomicFile::commit() {
  Result<void> written = write_all(descriptor_, buffer_, path_);
  buffer_.clear();
  if (temporary_.empty() || !written) return written;
  if (::fsync(descriptor_) != 0 && errno != EINVAL)
    return tl::unexpected(system_error("cannot write", path_));
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0)
    return tl::unexpected(system_error("cannot write", path_));
  ::close(descriptor_);
  descriptor_ = -1;
  return {};
}

}  // namespace posecoach
