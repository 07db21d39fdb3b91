#include "core/base/file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>

namespace posecoach {
namespace fs = std::filesystem;

namespace {

Error system_error(const char* verb, const fs::path& path) {
  const int reason = errno;
  const ErrorCode code = reason == ENOENT ? ErrorCode::NotFound : ErrorCode::Unreadable;
  return Error{code, std::string(verb) + " " + path.string() + ": " + std::strerror(reason)};
}

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

Result<std::string> read_file(const fs::path& path, std::size_t max_bytes) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored))
    return fail(ErrorCode::Unreadable, path.string() + " is a folder, not a file");
  std::FILE* file = std::fopen(path.c_str(), "rbe");
  if (file == nullptr) return tl::unexpected(system_error("cannot open", path));
  std::string bytes;
  char block[1 << 16];
  std::size_t got = 0;
  while ((got = std::fread(block, 1, sizeof block, file)) > 0 && bytes.size() <= max_bytes)
    bytes.append(block, got);
  const bool failed = std::ferror(file) != 0;
  const Error error = failed ? system_error("cannot read", path) : Error{};
  std::fclose(file);
  if (failed) return tl::unexpected(error);
  if (bytes.size() > max_bytes)
    return fail(ErrorCode::Unsupported, path.string() + " is larger than this kind of file may be");
  return bytes;
}

Result<void> write_file_atomically(const fs::path& path, std::string_view bytes) {
  if (path == "-") return write_all(STDOUT_FILENO, bytes, "standard output");
  const fs::path temporary = path.string() + ".tmp" + std::to_string(::getpid());
  const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) return tl::unexpected(system_error("cannot create", path));
  Result<void> written = write_all(descriptor, bytes, path);
  if (written && ::fsync(descriptor) != 0 && errno != EINVAL)
    written = tl::unexpected(system_error("cannot write", path));
  ::close(descriptor);
  if (written && std::rename(temporary.c_str(), path.c_str()) != 0)
    written = tl::unexpected(system_error("cannot write", path));
  if (!written) ::unlink(temporary.c_str());
  return written;
}

}  // namespace posecoach
