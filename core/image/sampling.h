// Cutting a square out of a picture, anywhere and turned, with bilinear weights in floating point.
#pragma once

#include <span>

#include "core/base/math.h"
#include "core/image/frame.h"

namespace posecoach {

// Where the square lies in the picture, in pixels of the picture (pixel i covers [i, i+1)): the point (u, v)
// of the square, both in [0, 1], is at `corner_px + u * across_px + v * down_px`.
struct CropSquare {
  Vec2 corner_px;
  Vec2 across_px;
  Vec2 down_px;

  Vec2 at(const Vec2& uv) const { return corner_px + uv.x * across_px + uv.y * down_px; }
};

enum class OutsidePicture { RepeatsTheEdge, IsBlack };

// A channel value c in [0, 255] becomes `scale * c + offset`.
struct ValueRange {
  float scale = 1;
  float offset = 0;
};

// Writes size x size RGB pixels, row by row, into `out` (3 * size * size values). Every output pixel is one
// bilinear sample at its centre; nothing is averaged when the square shrinks.
void sample_square(const Image& image, const CropSquare& square, int size, OutsidePicture outside,
                   ValueRange range, std::span<float> out);

}  // namespace posecoach
