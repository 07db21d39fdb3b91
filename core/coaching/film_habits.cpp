#include "core/coaching/film_habits.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace posecoach {
namespace {

using enum Feature;

struct FeatureRow {
  Viewpoint view;
  StrokeKind kind;
  std::string_view event;
  Feature feature;
  FeatureHabit habit;
};

constexpr auto kFace = Viewpoint::FaceOn, kLine = Viewpoint::DownTheLine;
constexpr auto kSwing = StrokeKind::FullSwing, kPutt = StrokeKind::Putt;

constexpr std::array kFeatureRows = {
    FeatureRow{kFace, kSwing, "mid_backswing", ChestToTarget, {-0.068, 1.07, 0.045}},
    FeatureRow{kFace, kSwing, "mid_backswing", ShoulderTilt, {26.2, 0.69, 7.5}},
    FeatureRow{kFace, kSwing, "mid_backswing", LeadArmBend, {34.8, 0.65, 20}},
    FeatureRow{kFace, kSwing, "top", HipsToTarget, {-0.006, 0.86, 0.05}},
    FeatureRow{kFace, kSwing, "top", ChestToTarget, {-0.079, 0.99, 0.06}},
    FeatureRow{kFace, kSwing, "mid_downswing", LeadArmBend, {30.8, 0.75, 22}},
    FeatureRow{kFace, kSwing, "impact", HipsToTarget, {0.001, 0.86, 0.05}},
    FeatureRow{kFace, kSwing, "impact", HeadUp, {0.034, 0.76, 0.06}},
    FeatureRow{kFace, kSwing, "mid_follow_through", HandsPlace, {0.032, 0.81, 0.09}},
    FeatureRow{kLine, kSwing, "top", ChestToBall, {0.004, 0.86, 0.045}},
    FeatureRow{kLine, kSwing, "top", ShoulderTilt, {21.4, 0.77, 8}},
    FeatureRow{kLine, kSwing, "mid_downswing", ChestToBall, {-0.015, 0.78, 0.04}},
    FeatureRow{kLine, kSwing, "mid_downswing", HandsToBall, {0.012, 0.80, 0.055}},
    FeatureRow{kLine, kSwing, "impact", HipsToBall, {-0.026, 0.90, 0.055}},
    FeatureRow{kLine, kSwing, "impact", ChestToBall, {-0.012, 0.90, 0.05}},
    FeatureRow{kLine, kSwing, "impact", HeadUp, {0.013, 0.83, 0.08}},
    FeatureRow{kFace, kPutt, "top", HeadToTarget, {0.004, 0.82, 0.015}},
    FeatureRow{kFace, kPutt, "end", HeadToTarget, {-0.005, 1.02, 0.03}},
    FeatureRow{kFace, kPutt, "end", LeadWristBreak, {-8.9, 1.9, 20}},
};

struct EventRow {
  Viewpoint view;
  StrokeKind kind;
  std::string_view event;
  EventHabit habit;
};

constexpr std::array kEventRows = {
    EventRow{kFace, kSwing, "takeaway", {0.022, 0.020}},
    EventRow{kFace, kSwing, "top", {-0.014, 0.013}},
    EventRow{kFace, kSwing, "mid_downswing", {-0.028, 0.005}},
    EventRow{kFace, kSwing, "impact", {0, 0.004}},
    EventRow{kLine, kSwing, "takeaway", {0.086, 0.045}},
    EventRow{kLine, kSwing, "top", {-0.023, 0.016}},
    EventRow{kLine, kSwing, "mid_downswing", {-0.006, 0.005}},
    EventRow{kLine, kSwing, "impact", {-0.019, 0.006}},
    EventRow{kFace, kPutt, "takeaway", {-0.043, 0.030}},
    EventRow{kFace, kPutt, "top", {-0.009, 0.038}},
    EventRow{kFace, kPutt, "impact", {-0.027, 0.020}},
};

std::optional<FeatureHabit> row_of(Viewpoint view, StrokeKind kind, std::string_view event, Feature feature) {
  for (const FeatureRow& row : kFeatureRows)
    if (row.view == view && row.kind == kind && row.event == event && row.feature == feature)
      return row.habit;
  return std::nullopt;
}

// From in front, the hands go on backwards in depth while they seem to turn back already; the whole body
// knows better. Where it says something quite different, the student's top is another than the coach's, and
// the hands are believed.
double top_of(const SwingEvents& found, const SwingEvents& coach, const Alignment& alignment,
              Viewpoint view) {
  constexpr double kMostShift = 0.2;  // of the backswing
  const double seen = found.time_of("top");
  if (view == kLine) return seen;
  const double answered = alignment.student_time(coach.time_of("top"));
  return std::abs(answered - seen) < kMostShift * (seen - found.takeaway_s) ? answered : seen;
}

}  // namespace

std::optional<FeatureHabit> feature_habit(Viewpoint view, StrokeKind kind, std::string_view event,
                                          Feature feature) {
  if (view != Viewpoint::Between) return row_of(view, kind, event, feature);
  const auto face = row_of(kFace, kind, event, feature), line = row_of(kLine, kind, event, feature);
  if (!face || !line) return std::nullopt;
  return FeatureHabit{0.5 * (face->usual_error + line->usual_error), 0.5 * (face->gain + line->gain),
                      std::max(face->clear, line->clear)};
}

EventHabit event_habit(Viewpoint view, StrokeKind kind, std::string_view event) {
  if (!is_one_camera(view)) return {0, 0};
  for (const EventRow& row : kEventRows)
    if (row.view == view && row.kind == kind && row.event == event) return row.habit;
  return {};
}

SwingEvents events_put_right(const SwingEvents& found, const SwingEvents& coach, const Alignment& alignment,
                             const JointTrack& student, Viewpoint view) {
  if (!is_one_camera(view)) return found;
  SwingEvents right = found;
  const auto habit = [&](std::string_view event) { return event_habit(view, found.kind, event).late_s; };
  for (SwingEvent& event : right.events) {
    if (event.name == "top") event.time_s = top_of(found, coach, alignment, view);
    event.time_s -= habit(event.name);
  }
  right.takeaway_s = std::max(0.0, right.takeaway_s - habit("takeaway"));
  SwingEvent& address = right.events.front();
  address.time_s = std::min(address.time_s, right.takeaway_s);
  const auto is_not_after = [](const SwingEvent& a, const SwingEvent& b) { return b.time_s <= a.time_s; };
  if (std::adjacent_find(right.events.begin(), right.events.end(), is_not_after) != right.events.end())
    return found;
  for (SwingEvent& event : right.events) event.frame = student.nearest_frame(event.time_s);
  return right;
}

}  // namespace posecoach
