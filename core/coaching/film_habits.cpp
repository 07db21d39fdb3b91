#include "core/coaching/film_habits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "core/coaching/body_axes.h"
#include "core/coaching/film_events.h"

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

// Before the stroke, from which one sees how a golfer stands.
constexpr double kSideLooked_s = 0.2;

// Of films, only the place of something that folds or breaks is seen, not by how much.
constexpr bool kNoSize = false;

constexpr std::array kFeatureRows = {
    FeatureRow{kFace, kSwing, "mid_backswing", ChestToTarget, {-0.053, 1.15, 0.045}},
    FeatureRow{kFace, kSwing, "mid_backswing", ShoulderTilt, {25.4, 0.65, 7.5}},
    FeatureRow{kFace, kSwing, "top", HipsToTarget, {-0.007, 0.87, 0.05}},
    FeatureRow{kFace, kSwing, "top", ChestToTarget, {-0.058, 1.08, 0.06}},
    FeatureRow{kFace, kSwing, "mid_downswing", LeadArmBend, {27.2, 0.68, 24}},
    FeatureRow{kFace, kSwing, "impact", HipsToTarget, {-0.004, 0.89, 0.05}},
    FeatureRow{kFace, kSwing, "impact", HeadUp, {0.034, 0.77, 0.06}},
    FeatureRow{kFace, kSwing, "mid_follow_through", HandsPlace, {0.011, 1.02, 0.09, kNoSize}},
    FeatureRow{kLine, kSwing, "top", ChestToBall, {-0.007, 0.86, 0.045}},
    FeatureRow{kLine, kSwing, "top", ShoulderTilt, {21.8, 0.74, 8.5}},
    FeatureRow{kLine, kSwing, "mid_downswing", ChestToBall, {-0.020, 0.91, 0.04}},
    FeatureRow{kLine, kSwing, "mid_downswing", HandsToBall, {0.024, 0.77, 0.055}},
    FeatureRow{kLine, kSwing, "impact", HipsToBall, {-0.032, 0.87, 0.055}},
    FeatureRow{kLine, kSwing, "impact", ChestToBall, {-0.020, 0.86, 0.05}},
    FeatureRow{kLine, kSwing, "impact", HeadUp, {0.016, 0.82, 0.08, kNoSize}},
    FeatureRow{kFace, kPutt, "top", HeadToTarget, {0.003, 0.85, 0.017}},
    FeatureRow{kFace, kPutt, "end", HeadToTarget, {0, 0.89, 0.03}},
    FeatureRow{kFace, kPutt, "end", LeadWristBreak, {-8.9, 1.9, 20, kNoSize}},
};

struct EventRow {
  Viewpoint view;
  StrokeKind kind;
  std::string_view event;
  EventHabit habit;
};

constexpr std::array kEventRows = {
    EventRow{kFace, kSwing, "address", {-0.012, 0.028}},
    EventRow{kFace, kSwing, "takeaway", {0.002, 0.018}},
    EventRow{kFace, kSwing, "toe_up", {-0.007, 0.014}},
    EventRow{kFace, kSwing, "mid_backswing", {0.024, 0.019}},
    EventRow{kFace, kSwing, "top", {-0.024, 0.010}},
    EventRow{kFace, kSwing, "mid_downswing", {-0.028, 0.005}},
    EventRow{kFace, kSwing, "impact", {0, 0.004}},
    EventRow{kFace, kSwing, "mid_follow_through", {0.010, 0.006}},
    EventRow{kFace, kSwing, "finish", {0, 0.017}},
    EventRow{kLine, kSwing, "address", {0.042, 0.048}},
    EventRow{kLine, kSwing, "takeaway", {-0.034, 0.022}},
    EventRow{kLine, kSwing, "toe_up", {0.005, 0.008}},
    EventRow{kLine, kSwing, "mid_backswing", {-0.037, 0.010}},
    EventRow{kLine, kSwing, "top", {-0.036, 0.009}},
    EventRow{kLine, kSwing, "mid_downswing", {-0.006, 0.005}},
    EventRow{kLine, kSwing, "impact", {-0.020, 0.006}},
    EventRow{kLine, kSwing, "mid_follow_through", {-0.022, 0.014}},
    EventRow{kLine, kSwing, "finish", {0, 0.025}},
    EventRow{kFace, kPutt, "address", {0.004, 0.041}},
    EventRow{kFace, kPutt, "takeaway", {0.025, 0.050}},
    EventRow{kFace, kPutt, "top", {-0.028, 0.012}},
    EventRow{kFace, kPutt, "impact", {-0.004, 0.008}},
    EventRow{kLine, kPutt, "address", {0.119, 0.097}},
    EventRow{kLine, kPutt, "takeaway", {0.041, 0.070}},
    EventRow{kLine, kPutt, "top", {-0.017, 0.012}},
    // Four bodies differ by less than half of this; putts of others were up to 0.06 s off.
    EventRow{kLine, kPutt, "impact", {-0.074, 0.035}},
};

struct MetricRow {
  Viewpoint view;
  std::string_view name;
  MetricHabit habit;
};

constexpr std::array kMetricRows = {
    MetricRow{kFace, "spine_side_address_deg", {0.4, 1.2}},
    MetricRow{kFace, "spine_side_top_deg", {2.4, 2.6}},
    MetricRow{kFace, "spine_side_impact_deg", {-1.0, 2.0}},
    MetricRow{kFace, "sway_top_cm", {-0.6, 1.3}},
    MetricRow{kFace, "slide_impact_cm", {-1.3, 2.1}},
    MetricRow{kFace, "lift_top_cm", {3.2, 1.8}},
    MetricRow{kFace, "lift_impact_cm", {3.4, 2.6}},
    MetricRow{kFace, "head_sway_top_cm", {-0.5, 2.0}},
    MetricRow{kFace, "head_lift_impact_cm", {3.5, 2.6}},
    MetricRow{kFace, "stance_width_percent", {12.6, 12}},
    MetricRow{kLine, "shoulder_turn_top_deg", {-1.9, 12}},
    MetricRow{kLine, "hip_turn_top_deg", {3.3, 15}},
    MetricRow{kLine, "x_factor_top_deg", {-5.3, 8}},
    MetricRow{kLine, "shoulder_tilt_top_deg", {-3.3, 3.7}},
    MetricRow{kLine, "spine_forward_address_deg", {0.7, 2.0}},
    MetricRow{kLine, "spine_forward_change_deg", {-0.1, 3.0}},
    MetricRow{kLine, "lift_top_cm", {-2.7, 3.0}},
    MetricRow{kLine, "lift_impact_cm", {0.1, 3.8}},
    MetricRow{kLine, "thrust_impact_cm", {-2.7, 2.5}},
    MetricRow{kLine, "hand_path_cm", {3.8, 3.7}},
    MetricRow{kLine, "head_lift_impact_cm", {2.0, 5.2}},
    MetricRow{kLine, "lead_knee_flex_address_deg", {-3.0, 3.0}},
    MetricRow{kLine, "trail_knee_flex_address_deg", {-2.2, 2.0}},
};

struct PhaseRow {
  Viewpoint view;
  StrokeKind kind;
  std::string_view from, to;
  PhaseHabit habit;
};

constexpr std::array kPhaseRows = {
    PhaseRow{kFace, kSwing, "takeaway", "top", {0.041, 1, 0}},
    PhaseRow{kFace, kSwing, "top", "mid_downswing", {0.093, 0.68, 0.27}},
    PhaseRow{kFace, kSwing, "top", "impact", {-0.045, 1, 0}},
    PhaseRow{kLine, kSwing, "takeaway", "top", {0, 1, 0}},
    PhaseRow{kLine, kSwing, "top", "mid_downswing", {0.103, 0.72, 0.28}},
    PhaseRow{kLine, kSwing, "top", "impact", {-0.040, 1, 0}},
    PhaseRow{kFace, kPutt, "top", "impact", {0.034, 0.79, 0}},
    PhaseRow{kLine, kPutt, "top", "impact", {0.035, 0.75, 0}},
    // Its beginning is seen a tenth of a second early or late: only half a backswing would be clear.
    PhaseRow{kLine, kPutt, "takeaway", "top", {0, 1, 0.55}},
};

// A camera at an angle sees most of what the nearer of the two sides sees.
Viewpoint nearest_side(Viewpoint view, const SwingEvents& found, const JointTrack& track,
                       const Sight& sight) {
  if (view != Viewpoint::Between || !sight.direction) return view;
  const BodyAxes axes = body_axes(track, found.time_of("address") - kSideLooked_s, found.time_of("address"));
  return std::abs(glm::dot(*sight.direction, axes.left)) > std::abs(glm::dot(*sight.direction, axes.front))
             ? kLine
             : kFace;
}

std::optional<FeatureHabit> row_of(Viewpoint view, StrokeKind kind, std::string_view event, Feature feature) {
  for (const FeatureRow& row : kFeatureRows)
    if (row.view == view && row.kind == kind && row.event == event && row.feature == feature)
      return row.habit;
  return std::nullopt;
}

// Where the answer says something quite different, the top is another than the other golfer's, and the hands
// are believed.
double top_from_angle(const SwingEvents& found, std::optional<double> answered_s) {
  constexpr double kMostShift = 0.2;  // of the backswing
  const double seen = found.time_of("top");
  return answered_s && std::abs(*answered_s - seen) < kMostShift * (seen - found.takeaway_s) ? *answered_s
                                                                                             : seen;
}

}  // namespace

std::optional<FeatureHabit> feature_habit(Viewpoint view, StrokeKind kind, std::string_view event,
                                          Feature feature) {
  if (view != Viewpoint::Between) return row_of(view, kind, event, feature);
  const auto face = row_of(kFace, kind, event, feature), line = row_of(kLine, kind, event, feature);
  if (!face || !line) return std::nullopt;
  return FeatureHabit{0.5 * (face->usual_error + line->usual_error), 0.5 * (face->gain + line->gain),
                      std::max(face->clear, line->clear), face->is_size_known && line->is_size_known};
}

std::optional<FeatureHabit> feature_habit(const Viewpoints& views, StrokeKind kind, std::string_view event,
                                          Feature feature) {
  if (!is_one_camera(views.coach)) return feature_habit(views.student, kind, event, feature);
  std::optional<FeatureHabit> habit = feature_habit(views.coach, kind, event, feature);
  if (!habit) return std::nullopt;
  if (!is_one_camera(views.student)) {
    habit->usual_error = -habit->usual_error;
    return habit;
  }
  if (!is_filmed_alike(views)) return std::nullopt;
  habit->usual_error = 0;
  habit->clear *= std::numbers::sqrt2;
  return habit;
}

EventHabit event_habit(Viewpoint view, StrokeKind kind, std::string_view event) {
  if (!is_one_camera(view)) return {0, 0};
  // From an angle no habits are known, so the doubt is twice the ordinary.
  if (view == Viewpoint::Between) return {0, 2 * EventHabit().spread_s};
  for (const EventRow& row : kEventRows)
    if (row.view == view && row.kind == kind && row.event == event) return row.habit;
  return {};
}

std::optional<MetricHabit> metric_habit(Viewpoint view, std::string_view name) {
  for (const MetricRow& row : kMetricRows)
    if (row.view == view && row.name == name) return row.habit;
  return std::nullopt;
}

std::optional<PhaseHabit> phase_habit(const Viewpoints& views, StrokeKind kind, std::string_view from,
                                      std::string_view to) {
  const auto row = [&](Viewpoint view) {
    const auto* const found = std::find_if(kPhaseRows.begin(), kPhaseRows.end(), [&](const PhaseRow& r) {
      return r.view == view && r.kind == kind && r.from == from && r.to == to;
    });
    return found == kPhaseRows.end() ? std::nullopt : std::optional(found->habit);
  };
  const auto student = row(views.student), coach = row(views.coach);
  if (!student || !coach) {
    if (student || !coach) return student;
    return PhaseHabit{1 / (1 + coach->usual_error) - 1, coach->gain, coach->clear};
  }
  return PhaseHabit{(1 + student->usual_error) / (1 + coach->usual_error) - 1,
                    std::min(student->gain, coach->gain), std::max(student->clear, coach->clear)};
}

SwingEvents events_put_right(const SwingEvents& found, const JointTrack& track, Viewpoint view,
                             const Sight& sight, double pace, std::optional<double> answered_top_s) {
  if (!is_one_camera(view)) return found;
  SwingEvents right = found;
  // Habits of time grow with it.
  const double slow = std::max(1.0, pace);
  const auto habit = [&](std::string_view event) {
    return slow * event_habit(view, found.kind, event).late_s;
  };
  const Viewpoint side = nearest_side(view, found, track, sight);
  const SeenStroke stroke{found, track, sight, side, slow};
  const bool is_swing = found.kind == kSwing, is_line = view == kLine && is_swing;
  const auto putt = view == kLine && !is_swing ? putt_down_the_line(stroke) : std::nullopt;
  for (SwingEvent& event : right.events) {
    if (event.name == "top")
      event.time_s = view == Viewpoint::Between ? top_from_angle(found, answered_top_s)
                     : putt                     ? putt->top_s
                                                : top_in_film(stroke);
    if (event.name == "impact" && putt) event.time_s = putt->impact_s;
    if (event.name == "toe_up" && side == kLine)
      event.time_s = toe_up_down_the_line(stroke).value_or(event.time_s);
    if (event.name == "finish") event.time_s = finish_in_film(stroke).value_or(event.time_s);
    event.time_s -= habit(event.name);
  }
  if (is_line)
    right.takeaway_s = takeaway_down_the_line(stroke, right.time_of("toe_up")).value_or(found.takeaway_s);
  if (putt) right.takeaway_s = putt->takeaway_s;
  right.takeaway_s = std::max(0.0, right.takeaway_s - habit("takeaway"));
  SwingEvent& address = right.events.front();
  address.time_s = std::max(0.0, std::min(address.time_s, right.takeaway_s));
  const auto is_not_after = [](const SwingEvent& a, const SwingEvent& b) { return b.time_s <= a.time_s; };
  if (std::adjacent_find(right.events.begin(), right.events.end(), is_not_after) != right.events.end())
    return found;
  for (SwingEvent& event : right.events) event.frame = track.nearest_frame(event.time_s);
  return right;
}

}  // namespace posecoach
