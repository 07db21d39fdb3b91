// Takes the trembling out of the landmarks of one person, frame after frame.
#pragma once

#include <array>
#include <vector>

#include "core/body/landmarks.h"
#include "core/vision/one_euro_filter.h"

namespace posecoach {

// Points in the picture whose speed counts in sizes of the person.
class PointSmoother {
 public:
  PointSmoother(std::size_t points, const OneEuroOptions& options)
      : filters_(2 * points, OneEuroFilter(options)) {}

  Vec2 smooth(std::size_t point, MediaTime time, const Vec2& position_px, double person_size_px);
  void reset();

 private:
  std::vector<OneEuroFilter> filters_;
};

class LandmarkSmoother {
 public:
  LandmarkSmoother();

  SeenPerson smooth(MediaTime time, const SeenPerson& person, double person_size_px);
  void reset();

 private:
  PointSmoother image_;
  std::vector<OneEuroFilter> world_;
  std::optional<std::array<double, kLandmarkCount>> visibility_;
};

}  // namespace posecoach
