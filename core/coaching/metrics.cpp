#include "core/coaching/metrics.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <initializer_list>

#include "core/coaching/advice_text.h"
#include "core/coaching/part_differences.h"
#include "core/coaching/posture.h"
#include "core/coaching/timing_advice.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

constexpr double kLeastConfidence = 0.3;
// A time that is not known to half of itself is not told.
constexpr double kWorstTime = 0.5;

// One body at the moments that metrics are read from, in its own axes at address.
struct Stroke {
  Stroke(const JointTrack& track_, const SwingEvents& events_)
      : track(track_),
        events(events_),
        axes(body_axes(track_, std::max(0.0, events_.takeaway_s - 0.2), events_.takeaway_s)),
        address(moment_of(track_, events_.time_of("address"))),
        top(moment_of(track_, events_.time_of("top"))),
        impact(moment_of(track_, events_.time_of("impact"))) {}

  // How far a point has moved over the ankles since address.
  Vec3 moved(const JointTrack& moment, const std::function<Vec3(const JointTrack&)>& point) const {
    const auto over_feet = [&](const JointTrack& body) {
      return point(body) - middle_of(body, 0, LeftAnkle, RightAnkle);
    };
    return in_axes(axes, over_feet(moment) - over_feet(address));
  }
  double turned_since_address(const JointTrack& moment, HumanoidJoint left, HumanoidJoint right) const {
    return std::remainder(turn_deg(moment, 0, left, right, axes) - turn_deg(address, 0, left, right, axes),
                          360.0);
  }

  const JointTrack& track;
  const SwingEvents& events;
  BodyAxes axes;
  JointTrack address, top, impact;
};

Vec3 hips(const JointTrack& body) {
  return middle_of_hips(body, 0);
}
Vec3 head(const JointTrack& body) {
  return body.position(0, Head);
}
Vec3 hands(const JointTrack& body) {
  return middle_of(body, 0, LeftWrist, RightWrist);
}

class Sheet {
 public:
  Sheet(const ComparedSwings& swings)
      : view_(swings.view),
        student_(swings.student, swings.student_events),
        coach_(swings.coach, swings.coach_events) {}

  const Stroke& student() const { return student_; }

  struct Rule {
    const char* name;
    const char* unit;
    double plus_minus = 0;             // of motion capture
    double plus_minus_one_camera = 0;  // of a webcam from a good side
    bool needs_target_direction = false, needs_ball_direction = false;
    const char* definition = "";
    // What a body can do; a webcam's value outside is the pose model's doing.
    double least = -1e9, most = 1e9;
  };
  void add(const Rule& rule, const JointTrack& seen, std::initializer_list<HumanoidJoint> joints,
           const std::function<double(const Stroke&)>& measure) {
    Metric metric = blank(rule);
    metric.plus_minus = is_one_camera(view_) ? rule.plus_minus_one_camera : rule.plus_minus;
    if ((rule.needs_target_direction && !sees_target_direction(view_)) ||
        (rule.needs_ball_direction && !sees_ball_direction(view_))) {
      metric.reason = text::hidden_by_view(view_);
    } else if (std::any_of(joints.begin(), joints.end(), [&](HumanoidJoint joint) {
                 return seen.confidence(0, joint) < kLeastConfidence;
               })) {
      metric.reason = text::hidden_joints("a joint is");
    } else if (const double value = measure(student_);
               is_one_camera(view_) && (value < rule.least || value > rule.most)) {
      metric.reason = text::implausible(value, rule.unit);
    }
    finish(metric, measure);
  }
  void add_time(const char* name, const char* unit, const char* definition, double relative_uncertainty,
                const std::function<double(const Stroke&)>& measure) {
    Metric metric = blank({name, unit, 0, 0, false, false, definition});
    metric.plus_minus = relative_uncertainty * std::abs(measure(student_));
    if (relative_uncertainty > kWorstTime) metric.reason = text::too_few_frames(student_.track.frame_rate());
    finish(metric, measure);
  }
  std::vector<Metric> take() { return std::move(metrics_); }

 private:
  static Metric blank(const Rule& rule) {
    Metric metric;
    metric.name = rule.name;
    metric.unit = rule.unit;
    metric.definition = rule.definition;
    return metric;
  }
  void finish(Metric& metric, const std::function<double(const Stroke&)>& measure) {
    metric.available = metric.reason.empty();
    metric.coach = measure(coach_);
    metric.value = measure(student_);
    metrics_.push_back(std::move(metric));
  }

  Viewpoint view_;
  Stroke student_, coach_;
  std::vector<Metric> metrics_;
};

double backswing_s(const Stroke& s) {
  return s.events.time_of("top") - s.events.takeaway_s;
}
double downswing_s(const Stroke& s) {
  return s.events.time_of("impact") - s.events.time_of("top");
}

void add_times(Sheet& sheet, double takeaway_off_s, double off_s) {
  const double back = std::hypot(takeaway_off_s, off_s) / backswing_s(sheet.student());
  const double down = std::sqrt(2.0) * off_s / downswing_s(sheet.student());
  sheet.add_time("tempo_ratio", "",
                 "backswing over downswing, takeaway to top to impact; about 3 for full swings, 2 for putts "
                 "(Tour Tempo)",
                 std::hypot(back, down), [](const Stroke& s) { return backswing_s(s) / downswing_s(s); });
  sheet.add_time("backswing_s", "s", "takeaway to top", back, backswing_s);
  sheet.add_time("downswing_s", "s", "top to impact; 0.23 to 0.30 s on tour (Tour Tempo)", down, downswing_s);
}

void add_full_swing(Sheet& sheet) {
  const Stroke& s = sheet.student();
  sheet.add({"shoulder_turn_top_deg", "deg", 3, 15, false, false,
             "shoulder line on the ground at the top, from address; 90 to 100 (GOLFTEC, Sportsbox)", 50, 130},
            s.top, {LeftShoulder, RightShoulder},
            [](const Stroke& b) { return -b.turned_since_address(b.top, LeftShoulder, RightShoulder); });
  sheet.add({"hip_turn_top_deg", "deg", 3, 15, false, false,
             "hip line on the ground at the top, from address; 40 to 45 (Sportsbox)", 15, 80},
            s.top, {LeftHip, RightHip},
            [](const Stroke& b) { return -b.turned_since_address(b.top, LeftHip, RightHip); });
  sheet.add({"x_factor_top_deg", "deg", 4, 16, false, false,
             "shoulder turn less hip turn at the top; depends on its definition", 10, 80},
            s.top, {LeftShoulder, RightShoulder, LeftHip, RightHip}, [](const Stroke& b) {
              return b.turned_since_address(b.top, LeftHip, RightHip) -
                     b.turned_since_address(b.top, LeftShoulder, RightShoulder);
            });
  sheet.add({"spine_forward_address_deg", "deg", 2, 6, false, true,
             "mid-hips to mid-shoulders out of the vertical, towards the ball; 30 to 40"},
            s.address, {LeftShoulder, RightShoulder, LeftHip, RightHip},
            [](const Stroke& b) { return spine_forward_deg(b.address, 0, b.axes); });
  sheet.add({"spine_forward_change_deg", "deg", 3, 7, false, true,
             "forward bend at impact less at address; near 0 keeps the posture"},
            s.impact, {LeftShoulder, RightShoulder, LeftHip, RightHip}, [](const Stroke& b) {
              return spine_forward_deg(b.impact, 0, b.axes) - spine_forward_deg(b.address, 0, b.axes);
            });
  sheet.add({"spine_side_impact_deg", "deg", 2, 6, true, false,
             "side bend away from the target at impact; 20 to 25 in teaching texts"},
            s.impact, {LeftShoulder, RightShoulder, LeftHip, RightHip},
            [](const Stroke& b) { return spine_side_deg(b.impact, 0, b.axes); });
  sheet.add({"sway_top_cm", "cm", 1, 3, true, false,
             "middle of the hips at the top, towards the target from address; its zero point matters"},
            s.top, {LeftHip, RightHip}, [](const Stroke& b) { return 100 * b.moved(b.top, hips).x; });
  sheet.add({"lift_impact_cm", "cm", 1, 3, false, false, "middle of the hips at impact, up from address"},
            s.impact, {LeftHip, RightHip}, [](const Stroke& b) { return 100 * b.moved(b.impact, hips).y; });
  sheet.add({"thrust_impact_cm", "cm", 1, 3, false, true,
             "middle of the hips at impact, towards the ball from address: early extension"},
            s.impact, {LeftHip, RightHip}, [](const Stroke& b) { return 100 * b.moved(b.impact, hips).z; });
  sheet.add(
      {"lead_arm_bend_top_deg", "deg", 3, 10, true, false, "elbow of the lead arm at the top; 0 is straight"},
      s.top, {LeftShoulder, LeftElbow, LeftWrist},
      [](const Stroke& b) { return bend_deg(b.top, 0, LeftShoulder, LeftElbow, LeftWrist); });
  sheet.add(
      {"hand_path_cm", "cm", 2, 6, false, true,
       "hands nearer the ball halfway down than halfway back (positive: over the top); hands, not club"},
      s.top, {LeftWrist, RightWrist}, [](const Stroke& b) {
        const JointTrack down = moment_of(b.track, b.events.time_of("mid_downswing"));
        const JointTrack back = moment_of(b.track, b.events.time_of("mid_backswing"));
        return 100 * (b.moved(down, hands).z - b.moved(back, hands).z);
      });
}

void add_putt(Sheet& sheet) {
  const Stroke& s = sheet.student();
  sheet.add(
      {"stroke_back_cm", "cm", 0.5, 3, true, false, "hands at the top, away from the target from address"},
      s.top, {LeftWrist, RightWrist}, [](const Stroke& b) { return -100 * b.moved(b.top, hands).x; });
  sheet.add({"hip_movement_cm", "cm", 0.5, 2, true, false,
             "middle of the hips from address to impact, along the target line"},
            s.impact, {LeftHip, RightHip}, [](const Stroke& b) { return 100 * b.moved(b.impact, hips).x; });
}

void add_posture(Sheet& sheet) {
  const Stroke& s = sheet.student();
  if (s.track.has(Head)) {
    sheet.add(
        {"head_sway_top_cm", "cm", 1, 3, true, false, "head at the top, towards the target from address"},
        s.top, {Head}, [](const Stroke& b) { return b.track.has(Head) ? 100 * b.moved(b.top, head).x : 0; });
    sheet.add({"head_lift_impact_cm", "cm", 1, 3, false, false, "head at impact, up from address"}, s.impact,
              {Head},
              [](const Stroke& b) { return b.track.has(Head) ? 100 * b.moved(b.impact, head).y : 0; });
  }
  sheet.add({"lead_knee_flex_address_deg", "deg", 3, 8, false, false,
             "knee of the lead leg at address; 0 is straight"},
            s.address, {LeftHip, LeftKnee, LeftAnkle},
            [](const Stroke& b) { return bend_deg(b.address, 0, LeftHip, LeftKnee, LeftAnkle); });
  sheet.add({"trail_knee_flex_address_deg", "deg", 3, 8, false, false,
             "knee of the trail leg at address; 0 is straight"},
            s.address, {RightHip, RightKnee, RightAnkle},
            [](const Stroke& b) { return bend_deg(b.address, 0, RightHip, RightKnee, RightAnkle); });
  sheet.add({"stance_width_percent", "%", 3, 10, true, false,
             "distance of the ankles over that of the shoulders, at address"},
            s.address, {LeftAnkle, RightAnkle}, [](const Stroke& b) {
              return 100 *
                     glm::distance(b.address.position(0, LeftAnkle), b.address.position(0, RightAnkle)) /
                     std::max(0.05, glm::distance(b.address.position(0, LeftShoulder),
                                                  b.address.position(0, RightShoulder)));
            });
}

}  // namespace

std::vector<Metric> measure_swing(const ComparedSwings& swings) {
  Sheet sheet(swings);
  add_times(sheet, takeaway_uncertainty_s(swings.student, swings.view),
            event_uncertainty_s(swings.student, swings.view));
  if (swings.student_events.kind == StrokeKind::FullSwing)
    add_full_swing(sheet);
  else
    add_putt(sheet);
  add_posture(sheet);
  return sheet.take();
}

}  // namespace posecoach
