// Which way a body stands: horizontal axes from its hips, shoulders and ankles.
#pragma once

#include "core/coaching/joint_track.h"

namespace posecoach {

struct BodyAxes {
  Vec3 left{1, 0, 0};   // his left hand's side
  Vec3 up{0, 1, 0};     // the world's up
  Vec3 front{0, 0, 1};  // where he looks at address: the ball
};

// The mean over the frames whose times lie in [begin_s, end_s], at least the nearest one.
BodyAxes body_axes(const JointTrack& track, double begin_s, double end_s);

// Turn about +Y, radians, that takes the front of `from` to the front of `to`.
double yaw_between(const BodyAxes& from, const BodyAxes& to);

// `v` turned about +Y: +Z goes towards +X for positive angles.
Vec3 turned(const Vec3& v, double yaw);

// Components of a world vector along left, up and front.
Vec3 in_axes(const BodyAxes& axes, const Vec3& v);

}  // namespace posecoach
