// Hands that hold one thing must still hold it in another person's proportions, where equal arm angles would
// part them.
#pragma once

#include "core/transfer/pose2d.h"

namespace posecoach {

// The wrists keep their mid-point and get the source's offset between them times `scale` (result's units per
// source's); the elbows follow half of the way. `weight` in [0, 1] blends from nothing to all of it. Does
// nothing where a wrist of the source was not seen.
void keep_hands_together(Pose2d& result, const Pose2d& source, double scale, double weight);

}  // namespace posecoach
