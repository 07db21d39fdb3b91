// The canonical joints at one instant, as the live loop hands them from stage to stage.
#pragma once

#include <array>

#include "core/base/math.h"
#include "core/body/humanoid.h"

namespace posecoach {

struct JointMoment {
  std::array<Vec3, kHumanoidJointCount> positions;          // world, metres
  std::array<double, kHumanoidJointCount> confidence_of{};  // negative: the body has no such joint

  JointMoment() { confidence_of.fill(-1); }
  bool has(HumanoidJoint joint) const { return confidence(joint) >= 0; }
  double confidence(HumanoidJoint joint) const { return confidence_of[static_cast<std::size_t>(joint)]; }
  const Vec3& at(HumanoidJoint joint) const { return positions[static_cast<std::size_t>(joint)]; }
  Vec3 middle(HumanoidJoint a, HumanoidJoint b) const { return 0.5 * (at(a) + at(b)); }
  void set(HumanoidJoint joint, const Vec3& position, double confidence) {
    positions[static_cast<std::size_t>(joint)] = position;
    confidence_of[static_cast<std::size_t>(joint)] = confidence;
  }
};

}  // namespace posecoach
