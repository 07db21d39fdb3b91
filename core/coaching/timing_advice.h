// What is too quick or too slow: the phases between the events, student against coach.
#pragma once

#include <vector>

#include "core/coaching/alignment.h"
#include "core/coaching/analysis.h"
#include "core/coaching/spatial_advice.h"

namespace posecoach {

struct TimingResult {
  std::vector<TimingAdvice> phases;  // in the order of time, each with its sentence
  std::vector<double> severity;      // of each, in units of what counts as a clear difference
  // Student's over coach's time from takeaway to impact. Far from 1 (a slow rehearsal, slow motion) the
  // phases are judged in proportion to it.
  double pace = 1;
  bool in_proportion = false;
};

TimingResult find_timing_advice(const ComparedSwings& swings, const Alignment& alignment);

// How far off an event's time may be ("takeaway" counts), seconds.
double event_uncertainty_s(const JointTrack& track, Viewpoint view, StrokeKind kind, std::string_view event);

}  // namespace posecoach
