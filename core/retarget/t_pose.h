// Brings a skeleton's rest pose to the T-pose in which two bodies are comparable. A limb whose rest direction
// is near the T-pose keeps it, so that the small differences of real T-poses count as shape; a limb far from
// it (A-pose arms, bones all along one axis) is turned onto it. Legs stand under the hips, seen from the
// front.
#pragma once

#include <vector>

#include "core/body/skeleton.h"

namespace posecoach {

struct TPose {
  std::vector<Quat> rotations;  // global, rest to T-pose, one a joint; identity where the rest pose is one
  std::vector<Vec3> offsets;    // from the parent in T-pose, world axes
  std::vector<Vec3> positions;  // the root at its own offset
};

TPose make_t_pose(const Skeleton& skeleton);

// The lowest joint that is above both, or kNoJoint when either is missing.
int common_ancestor(const Skeleton& skeleton, int a, int b);
bool is_ancestor(const Skeleton& skeleton, int ancestor, int joint);  // a joint is its own ancestor

// The joint that turns the pelvis (carries both hips) and the one that turns the chest (carries both
// shoulders); kNoJoint where hips or shoulders are missing.
int pelvis_joint(const Skeleton& skeleton);
int chest_joint(const Skeleton& skeleton);

}  // namespace posecoach
