#include "core/body/forward_kinematics.h"

#include "core/base/assert.h"
#include "core/base/index.h"

namespace posecoach {

Pose rest_pose(const Skeleton& skeleton) {
  return {skeleton.joint(0).offset, std::vector<Quat>(index(skeleton.size()), Quat(1, 0, 0, 0))};
}

void global_rotations(const Skeleton& skeleton, std::span<const Quat> local, std::span<Quat> global) {
  POSECOACH_ASSERT(local.size() == index(skeleton.size()) && global.size() == local.size());
  for (int i = 0; i < skeleton.size(); ++i) {
    const int parent = skeleton.joint(i).parent;
    global[index(i)] = parent == kNoJoint ? local[index(i)] : global[index(parent)] * local[index(i)];
  }
}

void local_rotations(const Skeleton& skeleton, std::span<const Quat> global, std::span<Quat> local) {
  POSECOACH_ASSERT(local.size() == index(skeleton.size()) && global.size() == local.size());
  for (int i = skeleton.size() - 1; i >= 0; --i) {
    const int parent = skeleton.joint(i).parent;
    local[index(i)] =
        parent == kNoJoint ? global[index(i)] : glm::conjugate(global[index(parent)]) * global[index(i)];
  }
}

void joint_positions(const Skeleton& skeleton, const Vec3& root_position, std::span<const Quat> global,
                     std::span<Vec3> positions) {
  POSECOACH_ASSERT(global.size() == index(skeleton.size()) && positions.size() == global.size());
  positions[0] = root_position;
  for (int i = 1; i < skeleton.size(); ++i) {
    const Joint& joint = skeleton.joint(i);
    positions[index(i)] = positions[index(joint.parent)] + global[index(joint.parent)] * joint.offset;
  }
}

std::vector<Vec3> forward_kinematics(const Skeleton& skeleton, const Pose& pose) {
  std::vector<Quat> global(pose.rotations.size());
  std::vector<Vec3> positions(pose.rotations.size());
  global_rotations(skeleton, pose.rotations, global);
  joint_positions(skeleton, pose.root_position, global, positions);
  return positions;
}

}  // namespace posecoach
