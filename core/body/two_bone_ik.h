// Closed-form inverse kinematics of a limb of two bones (shoulder-elbow-wrist, hip-knee-ankle).
#pragma once

#include "core/base/math.h"

namespace posecoach {

struct TwoBoneSolution {
  Vec3 middle;         // elbow or knee
  Vec3 end;            // wrist or ankle: the target, or as near to it as the limb reaches
  double deficit = 0;  // metres missing between `end` and the target; 0 when it was reached
};

// `root` stands still; `pole` is a point towards which the middle joint bends (only its side of the
// root-target line counts). Lengths must be positive. Exact lengths: |middle - root| = upper, |end - middle|
// = lower.
TwoBoneSolution solve_two_bones(const Vec3& root, const Vec3& target, const Vec3& pole, double upper,
                                double lower);

// The shortest rotation that takes direction `from` to direction `to`; identity when either is zero.
Quat swing_between(const Vec3& from, const Vec3& to);

}  // namespace posecoach
