#include "core/coaching/metric_sheet.h"

#include <algorithm>
#include <cmath>

#include "core/coaching/film_habits.h"
#include "core/coaching/part_differences.h"
#include "core/coaching/posture.h"
#include "core/coaching/text/metric_text.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

constexpr double kLeastConfidence = 0.3;
// A time that is not known to half of itself is not told.
constexpr double kWorstTime = 0.5;

Metric blank(std::string_view name) {
  const text::MetricText& words = text::metric(name);
  Metric metric;
  // A putt's tempo has figures of its own, and the name of any tempo.
  constexpr std::string_view kPutt = "putt_";
  metric.name = name.starts_with(kPutt) ? name.substr(kPutt.size()) : name;
  metric.title = words.title;
  metric.unit = words.unit;
  metric.definition = words.definition;
  if (words.usual) metric.usual = {words.usual->low, words.usual->high};
  metric.source = words.source;
  return metric;
}

std::string hidden_by(Needs needs, Viewpoint view) {
  if (needs == Needs::TargetDirection && !sees_target_direction(view)) return text::hidden_by_view(view);
  if (needs == Needs::BallDirection && !sees_ball_direction(view)) return text::hidden_by_view(view);
  if (needs == Needs::AllSides && is_one_camera(view)) return text::hidden_by_one_camera();
  return {};
}

}  // namespace

Stroke::Stroke(const JointTrack& track_, const SwingEvents& events_)
    : track(track_),
      events(events_),
      axes(body_axes(track_, std::max(0.0, events_.takeaway_s - 0.2), events_.takeaway_s)),
      address(moment_of(track_, events_.time_of("address"))),
      top(moment_of(track_, events_.time_of("top"))),
      impact(moment_of(track_, events_.time_of("impact"))) {}

Vec3 Stroke::moved(const JointTrack& moment, const std::function<Vec3(const JointTrack&)>& point) const {
  const auto over_feet = [&](const JointTrack& body) {
    return point(body) - middle_of(body, 0, LeftAnkle, RightAnkle);
  };
  return in_axes(axes, over_feet(moment) - over_feet(address));
}

double Stroke::turned(const JointTrack& moment, HumanoidJoint left, HumanoidJoint right) const {
  return std::remainder(turn_deg(moment, 0, left, right, axes) - turn_deg(address, 0, left, right, axes),
                        360.0);
}

MetricSheet::MetricSheet(const ComparedSwings& swings)
    : view_(swings.views.student),
      coach_view_(swings.views.coach),
      student_(swings.student, swings.student_events),
      coach_(swings.coach, swings.coach_events) {}

void MetricSheet::add(const MetricRule& rule, const JointTrack& seen,
                      std::initializer_list<HumanoidJoint> joints, const Measure& measure) {
  Metric metric = blank(rule.name);
  metric.plus_minus = is_one_camera(view_) ? rule.plus_minus_one_camera : rule.plus_minus;
  const auto habit =
      student_.events.kind == StrokeKind::FullSwing ? metric_habit(view_, rule.name) : std::nullopt;
  if (habit) metric.plus_minus = std::max(metric.plus_minus, habit->plus_minus);
  const double usual_error = habit ? habit->usual_error : 0;
  metric.reason = hidden_by(rule.needs, view_);
  const bool is_hidden = std::any_of(joints.begin(), joints.end(), [&](HumanoidJoint joint) {
    return seen.confidence(0, joint) < kLeastConfidence;
  });
  const bool is_measured_side = view_ == Viewpoint::FaceOn || view_ == Viewpoint::DownTheLine;
  if (metric.reason.empty() && is_measured_side && !habit && student_.events.kind == StrokeKind::FullSwing)
    metric.reason = text::not_from_this_side();
  if (metric.reason.empty() && is_hidden) metric.reason = text::joint_hidden();
  if (metric.reason.empty() && is_one_camera(view_)) {
    const double value = measure(student_) - usual_error;
    if (value < rule.least || value > rule.most) metric.reason = text::implausible(value, metric.unit);
  }
  enter(std::move(metric), measure);
  metrics_.back().value -= usual_error;
  if (!is_one_camera(coach_view_)) return;
  const auto coach_habit =
      coach_.events.kind == StrokeKind::FullSwing ? metric_habit(coach_view_, rule.name) : std::nullopt;
  std::optional<double>& coach = metrics_.back().coach;
  if (!hidden_by(rule.needs, coach_view_).empty())
    coach.reset();
  else if (coach_habit)
    *coach -= coach_habit->usual_error;
}

void MetricSheet::add_time(std::string_view name, double relative_uncertainty, const Measure& measure) {
  Metric metric = blank(name);
  metric.plus_minus = relative_uncertainty * std::abs(measure(student_));
  if (relative_uncertainty > kWorstTime) metric.reason = text::too_few_frames(student_.track.frame_rate());
  enter(std::move(metric), measure);
}

void MetricSheet::enter(Metric metric, const Measure& measure) {
  metric.available = metric.reason.empty();
  metric.coach = measure(coach_);
  metric.value = measure(student_);
  metrics_.push_back(std::move(metric));
}

bool MetricSheet::is_available(std::string_view name) const {
  return std::any_of(metrics_.begin(), metrics_.end(),
                     [name](const Metric& metric) { return metric.name == name && metric.available; });
}

void MetricSheet::grey(std::string reason) {
  if (!metrics_.back().reason.empty()) return;
  metrics_.back().available = false;
  metrics_.back().reason = std::move(reason);
}

void MetricSheet::say(std::string words) {
  metrics_.back().words = std::move(words);
}

}  // namespace posecoach
