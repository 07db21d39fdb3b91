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

double hip_height(const Skeleton& skeleton, const TPose& t_pose) {
  const double hips = hip_centre(skeleton, t_pose.positions).y;
  double lowest = hips;
  for (const HumanoidJoint role : {LeftAnkle, RightAnkle, LeftToe, RightToe, LeftToeTip, RightToeTip})
    if (const int joint = skeleton.find(role); joint != kNoJoint)
      lowest = std::min(lowest, t_pose.positions[static_cast<std::size_t>(joint)].y);
  return hips - lowest;
}

}  // namespace posecoach
