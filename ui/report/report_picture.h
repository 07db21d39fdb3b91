// A still picture of a pair of moments: the student, and the coach in the student's body.
#pragma once

#include <string>

#include "core/image/frame.h"

namespace posecoach {

struct ReportPicture {
  int student_frame = 0, coach_frame = 0;
  Image image;
  std::string caption;  // plain text: "Top: left elbow 14 cm away"
};

}  // namespace posecoach
