// A student's motion beside the coach's: what films and reports are drawn from. Holds references: everything
// must outlive the drawing.
#pragma once

#include "core/coaching/analysis.h"
#include "core/motion/motion.h"
#include "ui/render/figure.h"

namespace posecoach {

struct Comparison {
  const Analysis& analysis;  // with a path; its student frames are frames of the film or motion as given
  const Motion& student;     // frame k is frame first_frame + k of the film
  int first_frame = 0;
  const Motion& coach;   // in the student's body; its frames are the analysis' coach frames
  double coach_yaw = 0;  // turn about +Y, radians, that makes the coach face as the student does
  Palette palette = Palette::RedGreen;
};

}  // namespace posecoach
