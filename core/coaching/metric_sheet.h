// Inside measure_swing: a stroke at the moments that metrics are read from, and the sheet that they are
// entered on, each with its uncertainty, or greyed with the reason.
#pragma once

#include <functional>
#include <initializer_list>
#include <limits>
#include <string_view>
#include <vector>

#include "core/coaching/body_axes.h"
#include "core/coaching/spatial_advice.h"

namespace posecoach {

// One body, in its own axes at address.
struct Stroke {
  Stroke(const JointTrack& track, const SwingEvents& events);

  // How far a point has moved over the ankles since address: target, up, ball; metres.
  Vec3 moved(const JointTrack& moment, const std::function<Vec3(const JointTrack&)>& point) const;
  // Towards the target, degrees.
  double turned(const JointTrack& moment, HumanoidJoint left, HumanoidJoint right) const;

  const JointTrack& track;
  const SwingEvents& events;
  BodyAxes axes;
  JointTrack address, top, impact;
};

enum class Needs { Nothing, TargetDirection, BallDirection, AllSides };

struct MetricRule {
  std::string_view name;  // of core/coaching/text/metric_text.h
  Needs needs = Needs::Nothing;
  double plus_minus = 0;             // of motion capture
  double plus_minus_one_camera = 0;  // of a film from a good side
  // What a body can do; a film's value outside is the pose model's doing.
  double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
};

using Measure = std::function<double(const Stroke&)>;

class MetricSheet {
 public:
  explicit MetricSheet(const ComparedSwings& swings);

  const Stroke& student() const { return student_; }
  const Stroke& coach() const { return coach_; }
  Viewpoint view() const { return view_; }

  // `joints` must be seen at the student's moment.
  void add(const MetricRule& rule, const JointTrack& seen, std::initializer_list<HumanoidJoint> joints,
           const Measure& measure);
  // A time, or a ratio of times, known to this part of itself.
  void add_time(std::string_view name, double relative_uncertainty, const Measure& measure);
  // Whether this one, entered before, can be told.
  bool is_available(std::string_view name) const;
  // The last metric entered cannot be told after all.
  void grey(std::string reason);
  // What the last metric entered says in words.
  void say(std::string words);
  std::vector<Metric> take() { return std::move(metrics_); }

 private:
  void enter(Metric metric, const Measure& measure);

  Viewpoint view_, coach_view_;
  Stroke student_, coach_;
  std::vector<Metric> metrics_;
};

// What full swings and putts have of their own.
void add_swing_metrics(MetricSheet& sheet);
void add_putt_metrics(MetricSheet& sheet);

}  // namespace posecoach
