// Where the student stands: the coach's path of the hips, scaled by the ratio of hip heights about the origin
// of the coach's own world, so that who stands on the floor still does.
#pragma once

#include "core/motion/motion.h"
#include "core/retarget/t_pose.h"

namespace posecoach {

// Mid-hips above the lowest joint of the legs, T-pose, metres.
double hip_height(const Skeleton& skeleton, const TPose& t_pose);

// A joint above the lowest joint of the legs, T-pose, metres.
double sole_clearance(const Skeleton& skeleton, const TPose& t_pose, int joint);

// Mid-hips of a frame.
Vec3 hip_centre(const Skeleton& skeleton, std::span<const Vec3> positions);

}  // namespace posecoach
