// A picture's rows with room after each: FFmpeg's conversions read, in whole vector registers, a little past
// the end of a row, and past the end of a picture that is packed tightly.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/image/frame.h"

namespace posecoach {

class PaddedRows {
 public:
  const std::uint8_t* copy(const Image& image) {
    const auto row = static_cast<std::size_t>(3 * image.width);
    const std::size_t padded = (row + 2 * kRegister - 1) / kRegister * kRegister;
    stride_ = static_cast<int>(padded);
    bytes_.resize(padded * static_cast<std::size_t>(image.height));
    for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y)
      std::copy_n(image.rgb.data() + y * row, row, bytes_.data() + y * padded);
    return bytes_.data();
  }
  int stride() const { return stride_; }

 private:
  static constexpr std::size_t kRegister = 64;
  std::vector<std::uint8_t> bytes_;
  int stride_ = 0;
};

}  // namespace posecoach
