// Whether what looks like a stroke by the path of the hands can be one: a dance, a throw or a karate kick
// lifts and drops the hands as well.
#pragma once

#include "core/base/error.h"
#include "core/coaching/joint_track.h"
#include "core/coaching/sight.h"
#include "core/coaching/swing_events.h"

namespace posecoach {

// Both hands on one club, feet that stay where they are until impact, hands that come back to the ball, a
// backswing and a downswing in a golfer's proportion, a chest that turns. Errors: Unsupported, with what a
// golfer would not do.
Result<void> check_stroke(const JointTrack& track, const SwingEvents& swing, const Sight& sight);

}  // namespace posecoach
