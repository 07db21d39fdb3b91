// What a webcam and the pose stage do to a motion: joints off along the camera's axis much more than across
// it, off for long and shaking besides, limbs hidden behind the body or lost for a while. Measured on films
// of the simulated student (swing and putt, face-on and down the line, full model) against his true joints.
#pragma once

#include <random>

#include "core/motion/motion.h"

namespace posecoach {

// Where the camera stands in the world of a filmed motion: in this direction (core/pipeline/lift.h puts it
// there).
inline constexpr Vec3 kTowardsCamera{0, 0, 1};

// The same motion as a webcam would give it: positions without rotations, with confidence.
Motion with_webcam_noise(const Motion& motion, std::mt19937_64& random);

}  // namespace posecoach
