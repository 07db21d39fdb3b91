// A person who bends and turns, seen by markers.
#pragma once

#include <string>
#include <vector>

#include "core/motion/marker_track.h"
#include "core/motion/motion.h"

namespace posecoach::samples {

// The standard body in motion, known exactly.
Motion moving_person(int frames);

// Its joints as markers with these labels (label, role), in metres.
struct LabelledJoint {
  std::string label;
  HumanoidJoint role;
};
MarkerTrack markers_of(const Motion& motion, const std::vector<LabelledJoint>& labels);

// A full set of joint labels of one naming.
std::vector<LabelledJoint> blazepose_labels();
std::vector<LabelledJoint> openpose_labels();

}  // namespace posecoach::samples
