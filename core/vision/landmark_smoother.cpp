#include "core/vision/landmark_smoother.h"

namespace posecoach {
namespace {

// The constants that the networks' authors use for the body.
constexpr OneEuroOptions kImageOptions{0.05, 80, 1};
constexpr OneEuroOptions kWorldOptions{0.1, 40, 1};
constexpr double kNewVisibilityShare = 0.1;
constexpr double kSmallestPersonPx = 1e-6;

}  // namespace

Vec2 PointSmoother::smooth(std::size_t point, MediaTime time, const Vec2& position_px,
                           double person_size_px) {
  if (!(person_size_px >= kSmallestPersonPx)) return position_px;
  const double scale = 1.0 / person_size_px;
  return {filters_[2 * point].filter(time, position_px.x, scale),
          filters_[2 * point + 1].filter(time, position_px.y, scale)};
}

void PointSmoother::reset() {
  for (OneEuroFilter& filter : filters_) filter.reset();
}

LandmarkSmoother::LandmarkSmoother()
    : image_(kLandmarkCount, kImageOptions), world_(3 * kLandmarkCount, OneEuroFilter(kWorldOptions)) {}

SeenPerson LandmarkSmoother::smooth(MediaTime time, const SeenPerson& person, double person_size_px) {
  SeenPerson smooth = person;
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    smooth.image[i].position_px = image_.smooth(i, time, person.image[i].position_px, person_size_px);
    for (int axis = 0; axis < 3; ++axis)
      smooth.world[i].position_m[axis] =
          world_[3 * i + static_cast<std::size_t>(axis)].filter(time, person.world[i].position_m[axis], 1.0);
    if (visibility_) {
      const double before = (*visibility_)[i];
      smooth.image[i].visibility = before + kNewVisibilityShare * (person.image[i].visibility - before);
      smooth.world[i].visibility = smooth.image[i].visibility;
    }
  }
  visibility_.emplace();
  for (std::size_t i = 0; i < kLandmarkCount; ++i) (*visibility_)[i] = smooth.image[i].visibility;
  return smooth;
}

void LandmarkSmoother::reset() {
  image_.reset();
  for (OneEuroFilter& filter : world_) filter.reset();
  visibility_.reset();
}

}  // namespace posecoach
