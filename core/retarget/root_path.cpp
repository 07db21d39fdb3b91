#include "core/retarget/root_path.h"

#include <algorithm>

namespace posecoach {
namespace {

using enum HumanoidJoint;

}  // namespace

Vec3 hip_centre(const Skeleton& skeleton, std::span<const Vec3> positions) {
  return 0.5 * (positions[static_cast<std::size_t>(skeleton.find(LeftHip))] +
                positions[static_cast<std::size_t>(skeleton.find(RightHip))]);
}

double sole_clearance(const Skeleton& skeleton, const TPose& t_pose, int joint) {
  const double height = t_pose.positions[static_cast<std::size_t>(joint)].y;
  double lowest = height;
  for (const HumanoidJoint role : {LeftAnkle, RightAnkle, LeftToe, RightToe, LeftToeTip, RightToeTip})
    if (const int foot = skeleton.find(role); foot != kNoJoint)
      lowest = std::min(lowest, t_pose.positions[static_cast<std::size_t>(foot)].y);
  return height - lowest;
}

double hip_height(const Skeleton& skeleton, const TPose& t_pose) {
  return 0.5 * (sole_clearance(skeleton, t_pose, skeleton.find(LeftHip)) +
                sole_clearance(skeleton, t_pose, skeleton.find(RightHip)));
}

}  // namespace posecoach
