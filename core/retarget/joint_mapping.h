// Which joint of the coach answers each joint of the student, by what they stand for in a body; rigs may have
// more or fewer joints in spine, neck, shoulders, feet and hands.
#pragma once

#include <vector>

#include "core/motion/motion.h"
#include "core/retarget/t_pose.h"

namespace posecoach {

struct MappedJoint {
  int source = kNoJoint;    // kNoJoint: keeps its T-pose relation to its parent
  bool above_body = false;  // a root that only carries the body: it does not turn
  // The next mapped joints further out, and the coach's joints that answer them.
  std::vector<int> next;
  std::vector<int> next_source;
};

struct JointMapping {
  std::vector<MappedJoint> joints;  // one a joint of the target
};

// Errors: Incomplete naming what a body needs and one of the two lacks (hips, knees, ankles, shoulders,
// elbows, wrists).
Result<JointMapping> map_joints(const Skeleton& source, const Skeleton& target);

}  // namespace posecoach
