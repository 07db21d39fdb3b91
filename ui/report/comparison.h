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
  // In the student's body, facing as he does, mirrored where they are of different hands; its frames are the
  // analysis' coach frames.
  const Motion& coach;
  Palette palette = Palette::RedGreen;
};

}  // namespace posecoach
