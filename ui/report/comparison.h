// A student's motion beside the coach's: what films and reports are drawn from. Holds references: everything
// must outlive the drawing.
#pragma once

#include <span>

#include "core/coaching/analysis.h"
#include "core/motion/motion.h"
#include "core/session/marks.h"
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
  // By hand; frames of the film, pixels of a picture of this size.
  std::span<const Drawing> drawings = {};
  int drawn_width_px = 0, drawn_height_px = 0;
};

}  // namespace posecoach
