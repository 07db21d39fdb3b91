// A whole picture in a square, with black bars at two sides.
#pragma once

#include "core/image/sampling.h"

namespace posecoach {

class Letterbox {
 public:
  Letterbox(int width_px, int height_px)
      : side_px_(std::max(width_px, height_px)),
        bars_px_(0.5 * (side_px_ - width_px), 0.5 * (side_px_ - height_px)) {}

  CropSquare square() const { return {-bars_px_, {side_px_, 0}, {0, side_px_}}; }
  // From the square's coordinates, both in [0, 1], to the picture's pixels, and back.
  Vec2 to_picture(const Vec2& uv) const { return side_px_ * uv - bars_px_; }
  Vec2 from_picture(const Vec2& at_px) const { return (at_px + bars_px_) / side_px_; }
  double side_px() const { return side_px_; }

 private:
  double side_px_;
  Vec2 bars_px_;  // thickness of the left and the upper bar
};

}  // namespace posecoach
