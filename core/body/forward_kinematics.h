// From joint rotations to joint positions: p_child = p_parent + R_parent * offset_child, in world axes,
// metres. A local rotation turns a joint's children relative to its parent; at rest all rotations are the
// identity.
#pragma once

#include <span>
#include <vector>

#include "core/base/math.h"
#include "core/body/skeleton.h"

namespace posecoach {

struct Pose {
  Vec3 root_position;           // world, metres; replaces the root's offset
  std::vector<Quat> rotations;  // local, one a joint
};

Pose rest_pose(const Skeleton& skeleton);

// Both write one element a joint; the spans must have the skeleton's size.
void global_rotations(const Skeleton& skeleton, std::span<const Quat> local, std::span<Quat> global);
void local_rotations(const Skeleton& skeleton, std::span<const Quat> global, std::span<Quat> local);
void joint_positions(const Skeleton& skeleton, const Vec3& root_position, std::span<const Quat> global,
                     std::span<Vec3> positions);

std::vector<Vec3> forward_kinematics(const Skeleton& skeleton, const Pose& pose);

}  // namespace posecoach
