#include <algorithm>
#include <cmath>

#include "core/coaching/metric_sheet.h"
#include "core/coaching/part_differences.h"
#include "core/coaching/posture.h"
#include "core/coaching/text/metric_text.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

Vec3 hips(const JointTrack& body) {
  return middle_of_hips(body, 0);
}
Vec3 hands(const JointTrack& body) {
  return middle_of(body, 0, LeftWrist, RightWrist);
}
Vec3 head(const JointTrack& body) {
  return body.position(0, Head);
}

// Along the target line from takeaway to impact, at even instants.
std::vector<double> way_to_target(const Stroke& stroke, Vec3 (*point)(const JointTrack&)) {
  constexpr int kInstants = 40;
  const double begin = stroke.events.takeaway_s, end = stroke.events.time_of("impact");
  std::vector<double> way;
  for (int k = 0; k <= kInstants; ++k)
    way.push_back(stroke.moved(moment_of(stroke.track, begin + (end - begin) * k / kInstants), point).x);
  return way;
}

double range_of(const std::vector<double>& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return *most - *least;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto mean = [](const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
  };
  const double a_mean = mean(a), b_mean = mean(b);
  double both = 0, a_square = 0, b_square = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    both += (a[i] - a_mean) * (b[i] - b_mean);
    a_square += (a[i] - a_mean) * (a[i] - a_mean);
    b_square += (b[i] - b_mean) * (b[i] - b_mean);
  }
  const double product = std::sqrt(a_square * b_square);
  return product > 1e-12 ? both / product : 0;
}

double back_m(const Stroke& stroke) {
  return -stroke.moved(stroke.top, hands).x;
}

double through_m(const Stroke& stroke) {
  return stroke.moved(moment_of(stroke.track, stroke.events.time_of("end")), hands).x -
         stroke.moved(stroke.impact, hands).x;
}

void add_head(MetricSheet& sheet) {
  const Stroke& s = sheet.student();
  sheet.add({"head_movement_cm", Needs::TargetDirection, 0.5, 2}, s.top, {Head},
            [](const Stroke& b) { return 100 * range_of(way_to_target(b, head)); });
  sheet.add({"head_hands_coupling", Needs::TargetDirection, 0.1, 0.4}, s.top, {Head, LeftWrist, RightWrist},
            [](const Stroke& b) { return correlation(way_to_target(b, head), way_to_target(b, hands)); });
  const double moved_m = range_of(way_to_target(s, head));
  const double seen_m = is_one_camera(sheet.view()) ? 0.02 : 0.004;
  if (moved_m < seen_m)
    sheet.grey(text::head_is_still(moved_m));
  else
    sheet.say(text::head_goes(sheet.student().moved(s.top, head).x < 0));
}

}  // namespace

void add_putt_metrics(MetricSheet& sheet) {
  const Stroke& s = sheet.student();
  sheet.add({"stroke_back_cm", Needs::TargetDirection, 0.5, 3}, s.top, {LeftWrist, RightWrist},
            [](const Stroke& b) { return 100 * back_m(b); });
  sheet.add({"follow_through_ratio", Needs::TargetDirection, 0.1, 0.5}, s.top, {LeftWrist, RightWrist},
            [](const Stroke& b) { return through_m(b) / std::max(0.01, back_m(b)); });
  sheet.add({"shoulder_rock_deg", Needs::AllSides, 1}, s.top, {LeftShoulder, RightShoulder},
            [](const Stroke& b) { return -b.turned(b.top, LeftShoulder, RightShoulder); });
  sheet.add({"hip_movement_cm", Needs::TargetDirection, 0.5, 2}, s.impact, {LeftHip, RightHip},
            [](const Stroke& b) { return 100 * b.moved(b.impact, hips).x; });
  sheet.add({"spine_forward_address_deg", Needs::BallDirection, 2, 6}, s.address,
            {LeftShoulder, RightShoulder, LeftHip, RightHip},
            [](const Stroke& b) { return spine_forward_deg(b.address, 0, b.axes); });
  sheet.add({"wrist_break_deg", Needs::AllSides, 5}, s.impact, {LeftElbow, LeftWrist, RightWrist},
            [](const Stroke& b) {
              return std::remainder(wrist_break_deg(moment_of(b.track, b.events.time_of("end")), 0, b.axes) -
                                        wrist_break_deg(b.address, 0, b.axes),
                                    360.0);
            });
  if (s.track.has(Head) && sheet.coach().track.has(Head)) add_head(sheet);
}

}  // namespace posecoach
