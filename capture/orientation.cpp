#include "capture/orientation.h"

#include <cmath>
#include <cstring>

namespace posecoach {

Orientation orientation_from_matrix(double a, double b, double c, double d) {
  const bool swaps = std::abs(b) + std::abs(c) > std::abs(a) + std::abs(d);
  return {swaps, swaps ? c < 0 : a < 0, swaps ? b < 0 : d < 0};
}

Image upright_copy(const PictureRows& rows, Orientation orientation) {
  const bool swaps = orientation.swaps_axes;
  Image image = Image::black(swaps ? rows.height : rows.width, swaps ? rows.width : rows.height);
  const auto row_bytes = 3 * static_cast<std::size_t>(image.width);
  for (int y = 0; y < image.height; ++y) {
    const int v = orientation.mirrors_y ? image.height - 1 - y : y;
    std::uint8_t* written = &image.rgb[static_cast<std::size_t>(y) * row_bytes];
    if (!swaps && !orientation.mirrors_x) {
      std::memcpy(written, rows.first + static_cast<std::size_t>(v) * rows.stride, row_bytes);
      continue;
    }
    for (int x = 0; x < image.width; ++x, written += 3) {
      const int u = orientation.mirrors_x ? image.width - 1 - x : x;
      const auto column = static_cast<std::size_t>(swaps ? v : u);
      const auto row = static_cast<std::size_t>(swaps ? u : v);
      std::memcpy(written, rows.first + row * rows.stride + 3 * column, 3);
    }
  }
  return image;
}

}  // namespace posecoach
