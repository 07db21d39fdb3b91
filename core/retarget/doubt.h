// How far a motion's positions can be trusted, told from the motion itself: bones that change their length
// and joints that were not seen. Only a motion seen by a camera, whose joints have confidences between 0 and
// 1, is ever doubted: markers on the skin change their distances too, but lie where they were measured. A
// motion from a capture system or an animation is left alone by everything that repairs webcam input.
#pragma once

#include <vector>

#include "core/motion/motion.h"

namespace posecoach {

// Whether joints were guessed from pictures: a camera's network is never quite sure of one, a capture system
// has seen it or has not.
bool is_seen_by_camera(const Motion& motion);

// One number a frame in [0, 1]: 0 below 0.5 % of bone length error (mean of the bones, smoothed over half a
// second), 1 above 2.5 %; 0 throughout for motions that no camera saw.
std::vector<double> doubts(const Motion& motion);

// The motion with positions smoothed by a Gaussian where there is doubt, in between by the share of doubt.
inline constexpr double kWebcamSmoothing_s = 0.05;
Motion smoothed_where_doubtful(const Motion& motion, double sigma_s = kWebcamSmoothing_s);

}  // namespace posecoach
