// Labelled points over time, as motion capture systems record them (C3D, TRC), and the body that wears them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/base/time.h"
#include "core/motion/motion.h"

namespace posecoach {

struct MarkerTrack {
  std::vector<std::string> labels;
  std::vector<MediaTime> times;
  std::vector<Vec3> positions;  // element frame * labels.size() + marker, in the file's units and axes
  std::vector<char> seen;       // the same order; 0: the position means nothing
  double metres_per_unit = 0;   // 0: the file does not say

  std::size_t at(std::size_t frame, std::size_t marker) const { return frame * labels.size() + marker; }
};

// Fills the gaps of the chosen markers; `seen` stays as it is. A hidden marker is carried along with the
// three others that keep their distance to it best, from its last and its next sighting; with fewer others at
// hand it moves in a straight line. Outside its sightings it is carried or stands still.
void fill_gaps(MarkerTrack& track, const std::vector<std::size_t>& markers);

// Joints from markers. Known are labels that name joints (of any rig that rig.h knows, BlazePose's and
// OpenPose's landmarks), the Plug-in Gait set, and the one of GEARS golf captures; clubs, balls and other
// labels are ignored. Where only the outside of a joint carries a marker, that is the joint. Hip joints are
// estimated from the waist markers, by Bell, Pedersen & Brand (1990) for Plug-in Gait. Units that are not
// given, or make no person, and the axis that points up are told from the body.
// A joint's confidence is the seen part of its markers. The skeleton is measured (core/body).
// Errors: Incomplete (no frames, joints of a body missing, with what is missing and the labels).
Result<Motion> motion_from_markers(std::string_view file_name, MarkerTrack track);

}  // namespace posecoach
