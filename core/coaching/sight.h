// The line of sight of the one camera that saw the student. What lies along it was guessed by the pose model,
// by decimetres at times, so it counts a quarter wherever places are compared.
#pragma once

#include <glm/geometric.hpp>
#include <optional>

#include "core/base/math.h"

namespace posecoach {

struct Sight {
  // World, unit length; nothing where every direction is known equally well.
  std::optional<Vec3> direction;

  static constexpr double kDepthWeight = 0.25;

  Vec3 seen(const Vec3& v) const {
    return direction ? v - (1 - kDepthWeight) * glm::dot(v, *direction) * *direction : v;
  }
};

}  // namespace posecoach
