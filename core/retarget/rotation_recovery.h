// From joint positions back to rotations. Positions say nothing about a bone's spin about itself: a bone with
// one child takes the spin of the least turn from its parent; a joint that carries several bones (pelvis,
// chest, hand) is turned as a whole by the best fit (Kabsch; Horn's quaternion form).
#pragma once

#include <span>
#include <vector>

#include "core/motion/motion.h"
#include "core/retarget/t_pose.h"

namespace posecoach {

struct DirectionPair {
  Vec3 from, to;
  double weight = 1;
};

// The rotation that best takes every `from` to its `to` (least squares of the weighted vectors, lengths
// counting as given). Needs at least two directions that are not in line.
Quat best_rotation(std::span<const DirectionPair> pairs);

// The turn about `axis` (unit) that, after nothing else, best takes every `from` to its `to`.
Quat best_turn_about(const Vec3& axis, std::span<const DirectionPair> pairs);

// How each joint is turned away from the T-pose, in world axes (global; identity in T-pose), one frame.
// Positions that fit the skeleton's bones are reproduced exactly.
void recover_turns(const Skeleton& skeleton, const TPose& t_pose, std::span<const Vec3> positions,
                   std::span<Quat> turns);

// The same motion with rotations on its own skeleton: exact bone lengths, the nearest pose. Returns the
// motion itself where it has rotations.
Motion with_rotations(const Motion& motion);

}  // namespace posecoach
