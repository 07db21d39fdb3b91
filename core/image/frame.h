// One picture of a film or camera: immutable once made, shared between threads without copying.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/time.h"

namespace posecoach {

// 8-bit RGB, rows top to bottom without padding: pixel (x, y) starts at 3 * (y * width + x). Pixel (x, y)
// covers [x, x+1) x [y, y+1): its centre is at (x + 0.5, y + 0.5).
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;

  static Image black(int width, int height) {
    return {
        width, height,
        std::vector<std::uint8_t>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3)};
  }
  const std::uint8_t* pixel(int x, int y) const {
    return &rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(x))];
  }
  std::uint8_t* pixel(int x, int y) { return const_cast<std::uint8_t*>(std::as_const(*this).pixel(x, y)); }
  bool empty() const { return rgb.empty(); }
};

struct Frame {
  std::size_t index = 0;                   // 0, 1, 2, ... as the source counts; a gap is a lost frame
  MediaTime time;                          // from the source's own stamps
  std::optional<CaptureTime> captured_at;  // cameras only
  std::shared_ptr<const Image> image;      // never null
};

}  // namespace posecoach
