#include "core/coaching/pose_alignment.h"

#include <algorithm>
#include <cmath>

#include "core/coaching/advice_text.h"
#include "core/coaching/timing_advice.h"

namespace posecoach {
namespace {

// A pose this much early or late is told, or later by as much as the events are known.
constexpr double kClear_s = 0.06;
constexpr double kClearSigmas = 2;

// Mean distance of the joints where the path passes a time of the coach.
double apart_at(const Alignment& alignment, double coach_s) {
  double best_off = 1e9, apart = 0;
  for (std::size_t k = 0; k < alignment.steps.size(); ++k) {
    const double off = std::abs(alignment.coach.time(alignment.steps[k].second) - coach_s);
    if (off >= best_off) continue;
    best_off = off;
    apart = alignment.step_error_m[k];
  }
  return apart;
}

}  // namespace

std::vector<PoseMatch> match_poses(const ComparedSwings& swings, const Alignment& alignment) {
  std::vector<PoseMatch> matches;
  const double student_start = swings.student_events.takeaway_s, coach_start = swings.coach_events.takeaway_s;
  const auto off_s = [&](std::string_view event) {
    return event_uncertainty_s(swings.student, swings.view, swings.student_events.kind, event);
  };
  const double clear = std::max(kClear_s, kClearSigmas * std::hypot(off_s("takeaway"), off_s("top")));
  for (const SwingEvent& event : swings.coach_events.events) {
    PoseMatch match;
    match.event = event.name;
    const double student_s = alignment.student_time(event.time_s);
    match.student_frame = swings.student.nearest_frame(student_s);
    match.coach_frame = event.frame;
    match.student_s = student_s - student_start;
    match.coach_s = event.time_s - coach_start;
    match.late_s = match.student_s - match.coach_s;
    match.apart_m = apart_at(alignment, event.time_s);
    match.advice = text::pose_match(event.name, match.late_s, std::abs(match.late_s) >= clear);
    matches.push_back(std::move(match));
  }
  return matches;
}

}  // namespace posecoach
