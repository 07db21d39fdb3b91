#include "core/base/file.h"

#include <cstdio>

#include "core/base/atomic_file.h"
#include "core/base/system_error.h"

namespace posecoach {
namespace fs = std::filesystem;

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
  auto file = AtomicFile::create(path);
  if (!file) return tl::unexpected(file.error());
  if (const auto written = file->write(bytes); !written) return written;
  return file->commit();
}

}  // namespace posecoach
