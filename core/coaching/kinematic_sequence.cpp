#include "core/coaching/kinematic_sequence.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/assert.h"
#include "core/coaching/posture.h"
#include "core/coaching/signal.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

// Between frames the peaks come from the curve through them.
constexpr double kRate = 480;
// The lead arm's peak may come with impact itself.
constexpr double kPastImpact_s = 0.02;

double heading(const JointTrack& track, int frame, HumanoidJoint left, HumanoidJoint right) {
  const Vec3 line = track.position(frame, left) - track.position(frame, right);
  return degrees_from_radians(std::atan2(-line.z, line.x));
}

Vec3 lead_arm(const JointTrack& track, int frame) {
  return glm::normalize(middle_of(track, frame, LeftWrist, RightWrist) - track.position(frame, LeftShoulder));
}

// Degrees from frame to frame.
double step_deg(const JointTrack& track, int frame, Segment segment) {
  const auto turned = [&](HumanoidJoint left, HumanoidJoint right) {
    return std::remainder(heading(track, frame + 1, left, right) - heading(track, frame, left, right), 360.0);
  };
  if (segment == Segment::Pelvis) return turned(LeftHip, RightHip);
  if (segment == Segment::Chest) return turned(LeftShoulder, RightShoulder);
  const Vec3 from = lead_arm(track, frame), to = lead_arm(track, frame + 1);
  return degrees_from_radians(std::atan2(glm::length(glm::cross(from, to)), glm::dot(from, to)));
}

}  // namespace

bool KinematicSequence::is_from_the_ground_up() const {
  return order.size() == kSegmentCount && std::is_sorted(order.begin(), order.end());
}

KinematicSequence kinematic_sequence(const JointTrack& track, const SwingEvents& swing) {
  POSECOACH_ASSERT(swing.kind == StrokeKind::FullSwing);
  const double impact_s = swing.time_of("impact");
  const JointTrack down = track.resampled(kRate, swing.time_of("top"), impact_s + kPastImpact_s);
  const double frame_s = 1 / track.frame_rate();
  KinematicSequence sequence;
  for (std::size_t k = 0; k < kSegmentCount; ++k) {
    const auto segment = static_cast<Segment>(k);
    std::vector<double> speed;
    for (int frame = 0; frame + 2 < down.frame_count(); ++frame)
      speed.push_back(step_deg(down, frame, segment) * kRate);
    // Over a frame of the recording: what is quicker was not seen.
    speed = smoothed(speed, std::max(1.0, 0.4 * frame_s * kRate));
    if (speed.empty()) continue;
    const int peak = index_of_largest(speed, 0, static_cast<int>(speed.size()) - 1);
    const double at_s = down.time(0) + (vertex_near(speed, peak) + 0.5) / kRate;
    sequence.peaks[k] = {segment, speed[static_cast<std::size_t>(peak)], impact_s - at_s};
  }
  std::array<SegmentPeak, kSegmentCount> by_time = sequence.peaks;
  std::stable_sort(by_time.begin(), by_time.end(), [](const SegmentPeak& a, const SegmentPeak& b) {
    return a.before_impact_s > b.before_impact_s;
  });
  for (std::size_t k = 1; k < kSegmentCount; ++k)
    if (by_time[k - 1].before_impact_s - by_time[k].before_impact_s <= frame_s) return sequence;
  for (const SegmentPeak& peak : by_time) sequence.order.push_back(peak.segment);
  return sequence;
}

}  // namespace posecoach
