// Which pixels a round cone can touch, so that only those are tried.
#pragma once

#include "capture/cone_ray.h"

namespace posecoach::cone_ray {

struct PixelRange {
  int begin = 0, end = 0;
  void include(const PixelRange& other) {
    if (other.begin >= other.end) return;
    *this = begin >= end ? other : PixelRange{std::min(begin, other.begin), std::max(end, other.end)};
  }
};

// What of a row's pixels a cone's outline can touch. The outline lies inside the hull of two discs, whose
// radius and centre change linearly between them.
class Outline {
 public:
  Outline(const PreparedCone& cone, const View& view) {
    const auto disc = [&](const Float3& centre, float radius) {
      const float depth = std::max(centre.z - radius, 0.05F);
      const float slope = std::sqrt(centre.x * centre.x + centre.y * centre.y) / depth;
      return Disc{view.centre_x + view.focal_px * centre.x / centre.z,
                  view.centre_y + view.focal_px * centre.y / centre.z,
                  view.focal_px * radius / depth * std::sqrt(1 + slope * slope) + 1.0F};
    };
    visible_ = cone.begin.z > 0.1F && cone.end.z > 0.1F;
    if (!visible_) return;
    begin_ = disc(cone.begin, cone.begin_radius);
    end_ = disc(cone.end, cone.end_radius);
  }

  PixelRange rows(int height) const {
    if (!visible_) return {0, 0};
    return clamped(std::min(begin_.y - begin_.radius, end_.y - end_.radius),
                   std::max(begin_.y + begin_.radius, end_.y + end_.radius), height);
  }

  PixelRange columns(int row, int width) const {
    const float y = static_cast<float>(row) + 0.5F;
    float low = 0, high = 1;  // the part of the axis whose discs touch the row
    limit(begin_.y - begin_.radius - y, end_.y - end_.radius - y, low, high);
    limit(y - begin_.y - begin_.radius, y - end_.y - end_.radius, low, high);
    if (low > high) return {0, 0};
    const auto at = [&](float part, float sign) {
      return begin_.x + part * (end_.x - begin_.x) +
             sign * (begin_.radius + part * (end_.radius - begin_.radius));
    };
    return clamped(std::min(at(low, -1), at(high, -1)), std::max(at(low, 1), at(high, 1)), width);
  }

 private:
  struct Disc {
    float x = 0, y = 0, radius = 0;
  };
  // Keeps the part where a value that goes linearly from `first` to `last` is not positive.
  static void limit(float first, float last, float& low, float& high) {
    if (first <= 0 && last <= 0) return;
    if (first > 0 && last > 0) {
      low = 1;
      high = 0;
    } else if (first > 0) {
      low = std::max(low, first / (first - last));
    } else {
      high = std::min(high, first / (first - last));
    }
  }
  static PixelRange clamped(float low, float high, int size) {
    const float limit = static_cast<float>(size);
    return {static_cast<int>(std::clamp(std::floor(low), 0.0F, limit)),
            static_cast<int>(std::clamp(std::ceil(high) + 1.0F, 0.0F, limit))};
  }

  bool visible_ = false;
  Disc begin_, end_;
};

}  // namespace posecoach::cone_ray
