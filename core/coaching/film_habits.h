// What a pose model gets wrong by habit, seen from one side by one camera: measured on films of simulated
// strokes whose truth is known (posecoach evaluate coaching --through film; docs/ADVICE.md). What is told
// from a film is only what stands here: the rest cannot be told from that side.
#pragma once

#include <optional>
#include <string_view>

#include "core/coaching/joint_track.h"
#include "core/coaching/part_differences.h"
#include "core/coaching/sight.h"
#include "core/coaching/swing_events.h"
#include "core/coaching/viewpoint.h"

namespace posecoach {

// seen = usual_error + gain * truth, give or take; metres of a golfer of 1.80 m, or degrees. From address on:
// what was there at address already is taken off.
struct FeatureHabit {
  double usual_error = 0;
  double gain = 1;
  // From which on a difference is clear: faultless strokes, and those with another fault, stay below it.
  double clear = 0;
  bool is_size_known = true;  // else only that it is there, not by how much

  double truth_from(double seen) const { return (seen - usual_error) / gain; }
};
// Nothing where this side cannot tell. A camera at an angle tells only what both sides can.
std::optional<FeatureHabit> feature_habit(Viewpoint view, StrokeKind kind, std::string_view event,
                                          Feature feature);
// Of two films from one side the habits cancel and what wavers adds up; from two sides nothing can be told.
std::optional<FeatureHabit> feature_habit(const Viewpoints& views, StrokeKind kind, std::string_view event,
                                          Feature feature);

// What a metric is read off by from this side, and how much that wavers (two standard deviations), in its
// unit.
struct MetricHabit {
  double usual_error = 0, plus_minus = 0;
};
// Nothing where it was not measured from this side.
std::optional<MetricHabit> metric_habit(Viewpoint view, std::string_view name);

// How much later than it is an event is found, and how much that wavers, seconds.
struct EventHabit {
  double late_s = 0, spread_s = 0.03;
};
EventHabit event_habit(Viewpoint view, StrokeKind kind, std::string_view event);

// How a phase's time, as a part of the coach's, shows: seen = (1 + usual_error) * (1 + gain * (truth - 1)).
// The top of a film is the middle of a slow turn, and moves towards the slower side of it.
struct PhaseHabit {
  double usual_error = 0, gain = 1;
  // From which on it is too quick, and a slow one is not told; 0: as for motion capture.
  double clear = 0;
};
// Nothing for phases that are read as they are.
std::optional<PhaseHabit> phase_habit(const Viewpoints& views, StrokeKind kind, std::string_view from,
                                      std::string_view to);

// The events of somebody seen by one camera, put right: the top, which trembling hands blur, as the middle of
// their turn over a longer time, others by what this side shows of them (film_events.h; at an angle the
// nearer side), and every habit taken off. From an angle the whole body knows better than the hands where the
// top is: `answered_top_s` is where the alignment answers the other's. Unchanged where that would put them
// out of order, and where every side was seen.
SwingEvents events_put_right(const SwingEvents& found, const JointTrack& track, Viewpoint view,
                             const Sight& sight, double pace, std::optional<double> answered_top_s = {});

}  // namespace posecoach
