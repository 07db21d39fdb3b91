// People of any proportions, and what a recorded pose looks like on them: exact pairs for training and
// evaluation that no real recording has.
#pragma once

#include <array>
#include <random>

#include "core/transfer/pose3d.h"

namespace posecoach {

struct SyntheticBody {
  std::array<double, kBone2dCount> length_m{};
  Vec2 nose_forward_up_m;  // from where the recorded head joint would be, in the chest's axes
  double spine_lean = 0;   // of the rest pose against the recorded person's, radians, forwards
  // Rest direction of thighs and shins against the recorded person's, left side: outwards and forwards
  // (radians).
  Vec2 thigh_splay, shin_splay;
  double shoulder_lift = 0;  // of the upper arm's rest direction, radians
};

enum class SyntheticVariety {
  Common,   // as adults and children differ
  Extreme,  // as cartoon characters differ
  Mixed     // half and half
};
SyntheticBody random_body(std::mt19937_64& random, SyntheticVariety variety);

// The same turns of every bone, on the other body: `recorded_lengths` are the recorded person's over the
// whole clip (so that what varies within it, a shrug, stays visible). The mid-hip stays where it was.
Pose3d on_body(const Pose3d& recorded, const std::array<double, kBone2dCount>& recorded_lengths,
               const SyntheticBody& body);

}  // namespace posecoach
