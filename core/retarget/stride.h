// The student's feet go the coach's ways, measured in leg lengths. Turns alone would put them elsewhere where
// thighs and shins are proportioned differently.
#pragma once

#include "core/motion/motion.h"
#include "core/retarget/posed_motion.h"

namespace posecoach {

// Each ankle stands from its hip as the coach's does, times the ratio of the stretched legs; knees follow,
// feet keep their orientation. Legs of the coach's proportions stay as they are.
void stride_like(const Motion& coach, PosedMotion& student);

}  // namespace posecoach
