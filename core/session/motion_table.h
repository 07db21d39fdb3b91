// Motions and tracks as CSV, for spreadsheets: one row a frame, units in the header's names, "." decimals
// whatever the locale, CR LF as RFC 4180 wants it. What was not seen is an empty cell, never a 0.
#pragma once

#include <string>

#include "core/motion/motion.h"
#include "core/motion/pose_track.h"

namespace posecoach {

// frame,time_s,left_wrist_x_m,left_wrist_y_m,left_wrist_z_m,left_wrist_confidence,...: world frame, +Y up.
// Joints go by their canonical names where they have one. Frames count from `first_frame`, as the film does.
std::string csv_from_motion(const Motion& motion, int first_frame = 0);

// frame,time_s,left_wrist_x_px,left_wrist_y_px,left_wrist_visibility,...: the landmarks in the picture.
std::string csv_from_track(const PoseTrack& track);

}  // namespace posecoach
