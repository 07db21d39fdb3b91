#include "core/session/sha256.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <new>
#include <vector>

extern "C" {
#include <libavutil/mem.h>
#include <libavutil/sha.h>
}

#include "core/session/disk.h"

namespace posecoach {
namespace {

constexpr int kBits = 256;
constexpr std::size_t kReadBytes = std::size_t{1} << 18;

}  // namespace

void Sha256::Free::operator()(AVSHA* state) const {
  av_free(state);
}

Sha256::Sha256() : state_(av_sha_alloc()) {
  if (!state_) throw std::bad_alloc();
  av_sha_init(state_.get(), kBits);
}

void Sha256::add(std::string_view bytes) {
  av_sha_update(state_.get(), reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

std::string Sha256::finish() {
  std::array<std::uint8_t, kBits / 8> digest{};
  av_sha_final(state_.get(), digest.data());
  std::string text;
  for (const std::uint8_t byte : digest) {
    std::array<char, 3> hex{};
    std::snprintf(hex.data(), hex.size(), "%02x", static_cast<unsigned>(byte));
    text += hex.data();
  }
  return text;
}

Result<FileDigest> digest_file(const std::filesystem::path& path, const Progress& progress) {
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::error_code failed;
  if (std::filesystem::is_directory(path, failed))
    return fail(ErrorCode::Unreadable, path.string() + " is a folder, not a file");
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rbe"));
  if (!file) return tl::unexpected(disk_error("open", path));
  const auto size = std::filesystem::file_size(path, failed);
  const double all = failed || size == 0 ? 1 : static_cast<double>(size);
  std::vector<char> block(kReadBytes);
  Sha256 hash;
  FileDigest digest;
  while (const std::size_t got = std::fread(block.data(), 1, block.size(), file.get())) {
    hash.add({block.data(), got});
    digest.bytes += got;
    if (!report(progress, "checking", std::min(1.0, static_cast<double>(digest.bytes) / all)))
      return fail(ErrorCode::Cancelled, "stopped");
  }
  if (std::ferror(file.get()) != 0) return tl::unexpected(disk_error("read", path));
  digest.sha256 = hash.finish();
  return digest;
}

}  // namespace posecoach
