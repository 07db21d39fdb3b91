// What the window knows in three states: nothing yet, a usual moment, and everything at its limits.
#pragma once

#include "ui/screens/window_model.h"

namespace posecoach {

struct SampleWindow {
  WindowModel model;
  WindowState state;
};

SampleWindow empty_window();
SampleWindow normal_window();
// Long names, many of everything, numbers that are not finite, sources that failed.
SampleWindow extreme_window();

// A swing of the simulated student with a clear fault, analysed; made once.
std::shared_ptr<const ReviewSwing> sample_review();
// Another body, another fault, seen in another film.
std::shared_ptr<const ReviewSwing> second_review();
// The live loop in the middle of that swing.
CoachSnapshot sample_snapshot(LoopState loop);

}  // namespace posecoach
