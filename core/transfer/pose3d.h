// The 15 joints in space, and where they come from: frames of 3D motions. Metres, +Y up.
#pragma once

#include <array>
#include <vector>

#include "core/base/error.h"
#include "core/motion/motion.h"
#include "core/transfer/pose2d.h"

namespace posecoach {

struct Pose3d {
  std::array<Vec3, kJoint2dCount> positions;
  const Vec3& operator[](Joint2d joint) const { return positions[index(joint)]; }
  Vec3& operator[](Joint2d joint) { return positions[index(joint)]; }
};

// Every frame of a motion whose skeleton has head, shoulders, elbows, wrists, hips, knees and ankles. The
// nose is the head's joint (as Aberman et al., 2019), neck and mid-hip are mid-points. Errors: Incomplete
// naming the joints that are missing.
Result<std::vector<Pose3d>> poses_of(const Motion& motion);

// Where the camera stands: turned about the vertical by `yaw`, raised by `pitch`, looking at the body from so
// far away that there is no perspective. Radians; at zero it looks along -Z at a body that faces +Z.
struct CameraTurn {
  double yaw = 0;
  double pitch = 0;
};
Pose2d project(const Pose3d& pose, const CameraTurn& view);

// The person seen in a mirror: x -> -x, left and right exchanged.
Pose3d mirrored(const Pose3d& pose);

std::array<double, kBone2dCount> bone_lengths(const Pose3d& pose);

}  // namespace posecoach
