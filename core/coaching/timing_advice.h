// What is too quick or too slow: the phases between the events, student against coach.
#pragma once

#include <string_view>
#include <vector>

#include "core/coaching/alignment.h"
#include "core/coaching/analysis.h"
#include "core/coaching/spatial_advice.h"

namespace posecoach {

// "backswing", "transition", "downswing", "follow-through": what Advice::measure says of the time between two
// events.
std::string_view phase_name(std::string_view from, std::string_view to);

struct TimingResult {
  std::vector<TimingAdvice> phases;  // in the order of time, each with its sentence
  std::vector<double> severity;      // of each, in units of what counts as a clear difference
  double pace = 1;                   // as pace_of: other than 1, the phases are judged in proportion to it
  bool in_proportion = false;
};

// How many times as long as the coach's the stroke takes from takeaway to impact, where that is another pace
// (a slow rehearsal, a film in slow motion); 1 where it is about the same.
double pace_of(const SwingEvents& student, const SwingEvents& coach);

TimingResult find_timing_advice(const ComparedSwings& swings, const Alignment& alignment);

// How far off an event's time may be ("takeaway" counts), seconds. `pace` as pace_of.
double event_uncertainty_s(const JointTrack& track, Viewpoint view, StrokeKind kind, std::string_view event,
                           double pace = 1);

}  // namespace posecoach
