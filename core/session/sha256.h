// SHA-256 (FIPS 180-4), as `sha256sum` prints it: so that anybody can check a swing's files.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/progress.h"

namespace posecoach {

class Sha256 {
 public:
  void add(std::string_view bytes);
  // 64 hexadecimal digits; nothing may be added afterwards.
  std::string finish();

 private:
  void add_block(const unsigned char* block);

  std::array<std::uint32_t, 8> state_ = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                         0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<unsigned char, 64> block_{};
  std::size_t filled_ = 0;
  std::uint64_t bytes_ = 0;
};

struct FileDigest {
  std::uint64_t bytes = 0;
  std::string sha256;
};
// Errors: NotFound, Unreadable, Cancelled.
Result<FileDigest> digest_file(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace posecoach
