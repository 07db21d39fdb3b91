// Knees and elbows that bend as a human's can: not backwards, not further than flesh lets them. Turns carried
// over from a T-pose with bent knees to one with straight knees, a camera's depth errors and free rotations
// of a network all lead beyond.
//
// The limits, between the lines from joint centre to joint centre:
//   backwards 10 degrees, where hypermobility begins (Beighton, Solomon and Soskolne 1973; ordinary adults
//   reach 1 to 5: Soucie et al., Haemophilia 17, 2011, 500-507);
//   bent 155 degrees, above every mean of Soucie et al. (knees 152.6 in small children, elbows 150) and about
//   what heels under the body ask of knees.
// Beyond them a joint is turned back towards the limit, by the more the further it went and never past 5
// degrees over it: a smooth function of the pose, so that a smooth motion stays smooth.
//
// Which way is backwards: positions say nothing about a bone's spin, so the hinge is carried from the
// T-pose by the least turn, and the wide range in which thighs and upper arms spin about themselves (45 and
// 90 degrees each way) makes it a sector, narrow for elbows, and none for arms raised above the shoulder.
// Hips, shoulders, wrists and neck have no limit of their own here: their published ranges hold one axis at a
// time and say little about turns in between.
#pragma once

#include "core/retarget/posed_motion.h"
#include "core/retarget/retarget.h"

namespace posecoach {

// Motions within the limits stay as they are, to the last bit. Feet and hands keep their orientation.
JointLimitReport keep_joint_limits(PosedMotion& student);

// The metric of this stage: how far knees and elbows are beyond 15 degrees backwards (times how surely it is
// backwards) and 160 degrees bent.
struct JointLimitExcess {
  double largest_degrees = 0;
  double share = 0;  // of frames in which any of the four is beyond
};
JointLimitExcess joint_limit_excess(const Motion& motion);

}  // namespace posecoach
