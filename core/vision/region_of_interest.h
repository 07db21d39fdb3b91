// The turned square around a person that the landmark network looks at.
#pragma once

#include "core/image/sampling.h"

namespace posecoach {

struct RegionOfInterest {
  Vec2 centre_px;
  double size_px = 0;   // side of the square
  double rotation = 0;  // radians, clockwise as seen; 0 when the person stands upright

  bool is_finite() const {
    return std::isfinite(centre_px.x) && std::isfinite(centre_px.y) && std::isfinite(size_px) &&
           std::isfinite(rotation);
  }
  CropSquare square() const;
  // From the square's own coordinates, both in [0, 1], to the picture.
  Vec2 to_picture(const Vec2& uv) const { return square().at(uv); }
};

// Twice the distance from the centre of the hips to the point that fixes scale and rotation: the size of the
// person, without any margin.
double person_size_px(const Vec2& hip_centre_px, const Vec2& scale_point_px);

// The person's size and a quarter more, turned so that the scale point is straight above the hips.
RegionOfInterest region_from_points(const Vec2& hip_centre_px, const Vec2& scale_point_px);

}  // namespace posecoach
