#include "core/vision/region_of_interest.h"

#include <glm/geometric.hpp>

namespace posecoach {

CropSquare RegionOfInterest::square() const {
  const Vec2 across = size_px * Vec2(std::cos(rotation), std::sin(rotation));
  const Vec2 down = Vec2(-across.y, across.x);
  return {centre_px - 0.5 * across - 0.5 * down, across, down};
}

double person_size_px(const Vec2& hip_centre_px, const Vec2& scale_point_px) {
  return 2.0 * glm::length(scale_point_px - hip_centre_px);
}

RegionOfInterest region_from_points(const Vec2& hip_centre_px, const Vec2& scale_point_px) {
  constexpr double kMargin = 1.25;
  const Vec2 up = scale_point_px - hip_centre_px;
  const double turned = 0.5 * kPi - std::atan2(-up.y, up.x);
  return {hip_centre_px, kMargin * person_size_px(hip_centre_px, scale_point_px),
          turned - 2 * kPi * std::floor((turned + kPi) / (2 * kPi))};
}

}  // namespace posecoach
