// A pinhole camera as OpenGL needs it, for targets whose first row is the picture's top row.
#pragma once

#include <array>

#include "core/image/camera.h"

namespace posecoach::gl {

inline constexpr double kNear_m = 0.05;
inline constexpr double kFar_m = 200;

struct View {
  PinholeCamera camera;

  // Clip space x = a * x + c * z, y = b * y + d * z, w = z of a point in camera space; (-1, -1) is the top
  // left corner of the picture.
  std::array<float, 4> projection() const {
    const double w = camera.width_px, h = camera.height_px;
    return {static_cast<float>(2 * camera.focal_px / w), static_cast<float>(2 * camera.focal_px / h),
            static_cast<float>(2 * camera.centre_px.x / w - 1),
            static_cast<float>(2 * camera.centre_px.y / h - 1)};
  }
  static std::array<float, 2> depth_range() {
    return {static_cast<float>((kFar_m + kNear_m) / (kFar_m - kNear_m)),
            static_cast<float>(-2 * kFar_m * kNear_m / (kFar_m - kNear_m))};
  }
};

// A part of the target, in pixels, rows from the top.
struct PixelBox {
  int left = 0, top = 0, right = 0, bottom = 0;
  bool empty() const { return left >= right || top >= bottom; }
  int width() const { return right - left; }
  int height() const { return bottom - top; }
};

}  // namespace posecoach::gl
