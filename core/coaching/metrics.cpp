#include "core/coaching/metrics.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "core/coaching/metric_sheet.h"
#include "core/coaching/posture.h"
#include "core/coaching/timing_advice.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

double backswing_s(const Stroke& s) {
  return s.events.time_of("top") - s.events.takeaway_s;
}
double downswing_s(const Stroke& s) {
  return s.events.time_of("impact") - s.events.time_of("top");
}

// Off by how much each of the three moments may be.
struct TimesOff {
  double takeaway_s = 0, top_s = 0, impact_s = 0;
};

void add_times(MetricSheet& sheet, const TimesOff& off) {
  const Stroke& s = sheet.student();
  const bool is_putt = s.events.kind == StrokeKind::Putt;
  const double back = std::hypot(off.takeaway_s, off.top_s) / backswing_s(s);
  const double down = std::hypot(off.top_s, off.impact_s) / downswing_s(s);
  const double whole = std::hypot(off.takeaway_s, off.impact_s) / (backswing_s(s) + downswing_s(s));
  sheet.add_time(is_putt ? "putt_tempo_ratio" : "tempo_ratio", std::hypot(back, down),
                 [](const Stroke& b) { return backswing_s(b) / downswing_s(b); });
  sheet.add_time(is_putt ? "putt_backswing_s" : "backswing_s", back, backswing_s);
  sheet.add_time(is_putt ? "putt_downswing_s" : "downswing_s", down, downswing_s);
  if (is_putt)
    sheet.add_time("total_time_s", whole, [](const Stroke& b) { return backswing_s(b) + downswing_s(b); });
}

Vec3 head(const JointTrack& body) {
  return body.position(0, Head);
}

void add_posture(MetricSheet& sheet) {
  const Stroke& s = sheet.student();
  if (s.track.has(Head) && sheet.coach().track.has(Head)) {
    sheet.add({"head_sway_top_cm", Needs::TargetDirection, 1, 3}, s.top, {Head},
              [](const Stroke& b) { return 100 * b.moved(b.top, head).x; });
    sheet.add({"head_lift_impact_cm", Needs::Nothing, 1, 3}, s.impact, {Head},
              [](const Stroke& b) { return 100 * b.moved(b.impact, head).y; });
  }
  sheet.add({"lead_knee_flex_address_deg", Needs::Nothing, 3, 8}, s.address, {LeftHip, LeftKnee, LeftAnkle},
            [](const Stroke& b) { return bend_deg(b.address, 0, LeftHip, LeftKnee, LeftAnkle); });
  sheet.add({"trail_knee_flex_address_deg", Needs::Nothing, 3, 8}, s.address,
            {RightHip, RightKnee, RightAnkle},
            [](const Stroke& b) { return bend_deg(b.address, 0, RightHip, RightKnee, RightAnkle); });
  sheet.add({"stance_width_percent", Needs::TargetDirection, 3, 10}, s.address, {LeftAnkle, RightAnkle},
            [](const Stroke& b) {
              const auto distance = [&](HumanoidJoint left, HumanoidJoint right) {
                return glm::distance(b.address.position(0, left), b.address.position(0, right));
              };
              return 100 * distance(LeftAnkle, RightAnkle) /
                     std::max(0.05, distance(LeftShoulder, RightShoulder));
            });
}

}  // namespace

std::vector<Metric> measure_swing(const ComparedSwings& swings) {
  MetricSheet sheet(swings);
  const auto off_s = [&](std::string_view event) {
    return event_uncertainty_s(swings.student, swings.views.student, swings.student_events.kind, event,
                               pace_of(swings.student_events, swings.coach_events));
  };
  add_times(sheet, {off_s("takeaway"), off_s("top"), off_s("impact")});
  if (swings.student_events.kind == StrokeKind::FullSwing)
    add_swing_metrics(sheet);
  else
    add_putt_metrics(sheet);
  add_posture(sheet);
  return sheet.take();
}

}  // namespace posecoach
