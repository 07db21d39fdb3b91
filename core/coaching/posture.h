// Angles of a body at one moment of a track, degrees, for right-handed golfers (lead = left).
#pragma once

#include "core/coaching/body_axes.h"
#include "core/coaching/joint_track.h"

namespace posecoach {

Vec3 middle_of(const JointTrack& track, int frame, HumanoidJoint a, HumanoidJoint b);
Vec3 middle_of_shoulders(const JointTrack& track, int frame);
Vec3 middle_of_hips(const JointTrack& track, int frame);

// Bend at `joint`: 0 is straight.
double bend_deg(const JointTrack& track, int frame, HumanoidJoint above, HumanoidJoint joint,
                HumanoidJoint below);
// Turn about the vertical of the line from right to left joint, positive towards the target (to the golfer's
// left), from the axes' own left.
double turn_deg(const JointTrack& track, int frame, HumanoidJoint left, HumanoidJoint right,
                const BodyAxes& axes);
// How much higher the left joint is: angle of the line above the horizon.
double tilt_deg(const JointTrack& track, int frame, HumanoidJoint left, HumanoidJoint right);
// Of the line from mid-hips to mid-shoulders out of the vertical: towards the ball, and away from the target.
double spine_forward_deg(const JointTrack& track, int frame, const BodyAxes& axes);
double spine_side_deg(const JointTrack& track, int frame, const BodyAxes& axes);
// How far the lower hand on the grip is ahead of the lead forearm, towards the target, in the plane of target
// and gravity.
double wrist_break_deg(const JointTrack& track, int frame, const BodyAxes& axes);

}  // namespace posecoach
