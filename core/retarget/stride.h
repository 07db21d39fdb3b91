// The student's legs go the coach's ways. Turns away from the T-pose alone would slant them as the two
// T-poses differ, and put the feet elsewhere.
#pragma once

#include "core/motion/motion.h"
#include "core/retarget/posed_motion.h"

namespace posecoach {

// From each hip the ankle lies in the direction in which the coach's does; knees stay bent as they are, feet
// keep their orientation. Legs that point there already stay as they are, to the last bit.
void stride_like(const Motion& coach, PosedMotion& student);

}  // namespace posecoach
