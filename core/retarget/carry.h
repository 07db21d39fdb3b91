// Geometry's part of the way: the coach's poses on another body.
#pragma once

#include "core/retarget/retarget.h"

namespace posecoach {

// The methods `rotation` and `direction` (TurnTransfer), and the root's path scaled to the other's hip
// height. Errors: Incomplete naming the joints that either skeleton lacks.
Result<Motion> carried_by_turns(const Motion& coach, const Skeleton& body, RetargetMethod method,
                                RotationSource rotations);

}  // namespace posecoach
