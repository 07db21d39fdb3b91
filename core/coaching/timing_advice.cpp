#include "core/coaching/timing_advice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>
#include <utility>

#include "core/coaching/film_habits.h"
#include "core/coaching/known_fault.h"
#include "core/coaching/text/advice_text.h"

namespace posecoach {
namespace {

// A phase is clearly quick or slow when its ratio is off by this much, or by twice its own uncertainty.
constexpr double kClearRatio = 0.14;
constexpr double kClearSigmas = 2;
// Slower or quicker than this as a whole, and the golfer is rehearsing or the film is in slow motion.
constexpr double kOtherPace = 1.6;
// Frames that an event may be off, between two frames.
constexpr double kFramesOff = 0.15, kFramesOffOneCamera = 0.2;
constexpr double kLeastOff_s = 0.004;

using Phase = std::pair<std::string_view, std::string_view>;
constexpr std::array<Phase, 4> kFullSwing = {
    {{"takeaway", "top"}, {"top", "mid_downswing"}, {"top", "impact"}, {"impact", "finish"}}};
constexpr std::array<Phase, 3> kPutt = {{{"takeaway", "top"}, {"top", "impact"}, {"impact", "end"}}};

// Both sides as they are: the coach's events are found in his joints, a little beside where films have
// theirs, and a film shows a part of a difference only.
void put_right(TimingAdvice& phase, const PhaseHabit& habit, double pace) {
  constexpr double kLeast = 0.2;
  phase.coach_s *= 1 + habit.usual_error;
  const double should_s = phase.coach_s * pace;
  phase.student_s = should_s * std::max(kLeast, 1 + (phase.student_s / should_s - 1) / habit.gain);
  phase.ratio = phase.student_s / phase.coach_s;
  phase.plus_minus /= habit.gain;
}

}  // namespace

std::string_view phase_name(std::string_view from, std::string_view to) {
  if (to == "top") return "backswing";
  if (from == "top") return to == "mid_downswing" ? "transition" : "downswing";
  return "follow-through";
}

double pace_of(const SwingEvents& student, const SwingEvents& coach) {
  const auto whole = [](const SwingEvents& events) { return events.time_of("impact") - events.takeaway_s; };
  const double ratio = whole(student) / std::max(1e-3, whole(coach));
  return ratio > kOtherPace || ratio < 1 / kOtherPace ? ratio : 1;
}

double event_uncertainty_s(const JointTrack& track, Viewpoint view, StrokeKind kind, std::string_view event,
                           double pace) {
  const double rate = track.frame_rate(), frame_s = rate > 0 ? 1 / rate : 0;
  if (!is_one_camera(view)) return std::max(kLeastOff_s, kFramesOff * frame_s);
  return std::hypot(pace * event_habit(view, kind, event).spread_s, kFramesOffOneCamera * frame_s);
}

TimingResult find_timing_advice(const ComparedSwings& swings, const Alignment& alignment) {
  const SwingEvents& student = swings.student_events;
  const SwingEvents& coach = swings.coach_events;
  TimingResult result;
  const auto duration = [](const SwingEvents& events, const Phase& phase) {
    return events.time_of(phase.second) - events.time_of(phase.first);
  };
  result.pace = pace_of(student, coach);
  result.in_proportion = result.pace != 1;
  const std::span<const Phase> phases =
      student.kind == StrokeKind::Putt ? std::span<const Phase>(kPutt) : kFullSwing;
  for (const Phase& phase : phases) {
    // A webcam's hands settle late, and some motions end before they do.
    const bool is_end_known = student.is_end_seen && coach.is_end_seen && !is_one_camera(swings.views);
    if (phase.first == "impact" && !is_end_known) continue;
    const auto off_s = [&](std::string_view event) {
      return event_uncertainty_s(swings.student, swings.views.student, student.kind, event, result.pace);
    };
    const auto coach_off_s = [&](std::string_view event) {
      return event_uncertainty_s(swings.coach, swings.views.coach, coach.kind, event);
    };
    TimingAdvice advice;
    advice.from = phase.first;
    advice.to = phase.second;
    advice.student_s = duration(student, phase);
    advice.coach_s = duration(coach, phase);
    if (advice.student_s <= 0 || advice.coach_s <= 0) continue;
    advice.ratio = advice.student_s / advice.coach_s;
    advice.plus_minus =
        advice.ratio *
        std::hypot(std::hypot(off_s(phase.first), off_s(phase.second)) / advice.student_s,
                   std::hypot(coach_off_s(phase.first), coach_off_s(phase.second)) / advice.coach_s);
    const double along_path = alignment.student_time(coach.time_of(phase.second)) -
                              alignment.student_time(coach.time_of(phase.first));
    advice.path_ratio = along_path / advice.coach_s;
    const auto habit = phase_habit(swings.views, student.kind, phase.first, phase.second);
    if (habit) put_right(advice, *habit, result.pace);
    const double relative = advice.ratio / result.pace, relative_on_path = advice.path_ratio / result.pace;
    const double clear = std::max(kClearRatio, kClearSigmas * advice.plus_minus / advice.ratio);
    double severity = habit && habit->clear > 0 ? std::max(0.0, 1 - relative) / habit->clear
                                                : std::abs(std::log(relative)) / clear;
    // The path must say the same: an event that was found late on one side alone is no advice.
    const bool path_agrees = (relative_on_path - 1) * (relative - 1) > 0;
    if (!path_agrees) severity *= 0.5;
    // The way to the finish is the golfer's own affair, unless it is far off.
    if (phase.first == "impact") severity *= 0.5;
    severity *= swings.strictness.of(JudgedPart::Timing);
    advice.fault = known_timing_fault(advice.from, advice.to, relative, student.kind);
    advice.advice = text::timing(advice, student.kind, result.pace, severity >= 1);
    result.phases.push_back(std::move(advice));
    result.severity.push_back(severity);
  }
  return result;
}

}  // namespace posecoach
