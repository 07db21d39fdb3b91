#include <algorithm>
#include <cmath>

#include "core/coaching/kinematic_sequence.h"
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

double x_factor(const Stroke& stroke, const JointTrack& moment) {
  return stroke.turned(moment, LeftHip, RightHip) - stroke.turned(moment, LeftShoulder, RightShoulder);
}

// The first half of the way down, where good golfers' hips run ahead.
double x_factor_stretch(const Stroke& stroke) {
  const double top = stroke.events.time_of("top"), impact = stroke.events.time_of("impact");
  constexpr int kInstants = 12;
  double largest = x_factor(stroke, stroke.top);
  for (int k = 1; k <= kInstants; ++k)
    largest = std::max(largest,
                       x_factor(stroke, moment_of(stroke.track, top + 0.5 * k / kInstants * (impact - top))));
  return largest - x_factor(stroke, stroke.top);
}

void add_turns(MetricSheet& sheet) {
  const Stroke& s = sheet.student();
  sheet.add({"shoulder_turn_top_deg", Needs::Nothing, 3, 15, 50, 130}, s.top, {LeftShoulder, RightShoulder},
            [](const Stroke& b) { return -b.turned(b.top, LeftShoulder, RightShoulder); });
  sheet.add({"shoulder_turn_impact_deg", Needs::AllSides, 4, 15}, s.impact, {LeftShoulder, RightShoulder},
            [](const Stroke& b) { return b.turned(b.impact, LeftShoulder, RightShoulder); });
  sheet.add({"hip_turn_top_deg", Needs::Nothing, 3, 15, 15, 80}, s.top, {LeftHip, RightHip},
            [](const Stroke& b) { return -b.turned(b.top, LeftHip, RightHip); });
  sheet.add({"hip_turn_impact_deg", Needs::AllSides, 4, 15}, s.impact, {LeftHip, RightHip},
            [](const Stroke& b) { return b.turned(b.impact, LeftHip, RightHip); });
  sheet.add({"x_factor_top_deg", Needs::Nothing, 4, 16, 10, 80}, s.top,
            {LeftShoulder, RightShoulder, LeftHip, RightHip},
            [](const Stroke& b) { return x_factor(b, b.top); });
  // A difference is no better than what it is made of.
  for (const std::string_view turn : {"shoulder_turn_top_deg", "hip_turn_top_deg"})
    if (!sheet.is_available(turn)) sheet.grey(text::not_without(text::metric(turn).title));
  sheet.add({"x_factor_stretch_deg", Needs::AllSides, 3, 16}, s.top,
            {LeftShoulder, RightShoulder, LeftHip, RightHip}, x_factor_stretch);
  sheet.add({"shoulder_tilt_top_deg", Needs::Nothing, 2, 10}, s.top, {LeftShoulder, RightShoulder},
            [](const Stroke& b) { return -tilt_deg(b.top, 0, LeftShoulder, RightShoulder); });
}

void add_spine(MetricSheet& sheet) {
  const Stroke& s = sheet.student();
  const std::initializer_list<HumanoidJoint> trunk = {LeftShoulder, RightShoulder, LeftHip, RightHip};
  sheet.add({"spine_forward_address_deg", Needs::BallDirection, 2, 6}, s.address, trunk,
            [](const Stroke& b) { return spine_forward_deg(b.address, 0, b.axes); });
  sheet.add({"spine_forward_change_deg", Needs::BallDirection, 3, 7}, s.impact, trunk, [](const Stroke& b) {
    return spine_forward_deg(b.impact, 0, b.axes) - spine_forward_deg(b.address, 0, b.axes);
  });
  sheet.add({"spine_side_address_deg", Needs::TargetDirection, 2, 6}, s.address, trunk,
            [](const Stroke& b) { return spine_side_deg(b.address, 0, b.axes); });
  sheet.add({"spine_side_top_deg", Needs::TargetDirection, 2, 6}, s.top, trunk,
            [](const Stroke& b) { return spine_side_deg(b.top, 0, b.axes); });
  sheet.add({"spine_side_impact_deg", Needs::TargetDirection, 2, 6}, s.impact, trunk,
            [](const Stroke& b) { return spine_side_deg(b.impact, 0, b.axes); });
}

void add_hips(MetricSheet& sheet) {
  const Stroke& s = sheet.student();
  const std::initializer_list<HumanoidJoint> both = {LeftHip, RightHip};
  sheet.add({"sway_top_cm", Needs::TargetDirection, 1, 3}, s.top, both,
            [](const Stroke& b) { return 100 * b.moved(b.top, hips).x; });
  sheet.add({"slide_impact_cm", Needs::TargetDirection, 1, 3}, s.impact, both,
            [](const Stroke& b) { return 100 * b.moved(b.impact, hips).x; });
  sheet.add({"lift_top_cm", Needs::Nothing, 1, 3}, s.top, both,
            [](const Stroke& b) { return 100 * b.moved(b.top, hips).y; });
  sheet.add({"lift_impact_cm", Needs::Nothing, 1, 3}, s.impact, both,
            [](const Stroke& b) { return 100 * b.moved(b.impact, hips).y; });
  sheet.add({"thrust_impact_cm", Needs::BallDirection, 1, 3}, s.impact, both,
            [](const Stroke& b) { return 100 * b.moved(b.impact, hips).z; });
}

void add_arms(MetricSheet& sheet) {
  const Stroke& s = sheet.student();
  sheet.add({"lead_arm_bend_top_deg", Needs::TargetDirection, 3, 10}, s.top,
            {LeftShoulder, LeftElbow, LeftWrist},
            [](const Stroke& b) { return bend_deg(b.top, 0, LeftShoulder, LeftElbow, LeftWrist); });
  sheet.add({"hand_path_cm", Needs::BallDirection, 2, 6}, s.top, {LeftWrist, RightWrist},
            [](const Stroke& b) {
              const JointTrack down = moment_of(b.track, b.events.time_of("mid_downswing"));
              const JointTrack back = moment_of(b.track, b.events.time_of("mid_backswing"));
              return 100 * (b.moved(down, hands).z - b.moved(back, hands).z);
            });
}

void add_sequence(MetricSheet& sheet) {
  const Stroke& s = sheet.student();
  const auto of = [](const Stroke& stroke) { return kinematic_sequence(stroke.track, stroke.events); };
  sheet.add({"kinematic_sequence", Needs::AllSides}, s.impact, {},
            [&](const Stroke& b) { return of(b).is_from_the_ground_up() ? 1.0 : 0.0; });
  const KinematicSequence students = of(s);
  if (students.order.empty())
    sheet.grey(text::sequence_too_close(s.track.frame_rate()));
  else
    sheet.say(text::sequence(students.order));
  const auto add_peak = [&](std::string_view name, Segment segment) {
    sheet.add({name, Needs::AllSides, 40}, s.impact, {}, [&of, segment](const Stroke& b) {
      return of(b).peaks[static_cast<std::size_t>(segment)].speed_deg_s;
    });
    // A peak of a few hundredths of a second is cut off between the frames of a webcam.
    constexpr double kLeastRate = 59;
    if (s.track.frame_rate() < kLeastRate) sheet.grey(text::too_few_frames(s.track.frame_rate()));
  };
  add_peak("pelvis_peak_deg_s", Segment::Pelvis);
  add_peak("chest_peak_deg_s", Segment::Chest);
  add_peak("lead_arm_peak_deg_s", Segment::LeadArm);
}

}  // namespace

void add_swing_metrics(MetricSheet& sheet) {
  add_turns(sheet);
  add_spine(sheet);
  add_hips(sheet);
  add_arms(sheet);
  add_sequence(sheet);
}

}  // namespace posecoach
