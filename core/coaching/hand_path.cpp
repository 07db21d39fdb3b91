#include "core/coaching/hand_path.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/median.h"
#include "core/coaching/pendulum.h"
#include "core/coaching/signal.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

constexpr double kLeastSmoothing_s = 0.006, kMostSmoothing_s = 0.020;
// A filmed putt moves as little as its joints tremble, and no part of it is shorter than a third of a second.
constexpr double kPuttSmoothing_s = 0.035;
// Jitter of quiet hands below which they need no smoothing, and from which on they need the most.
constexpr double kQuiet_m = 0.0003, kTrembling_m = 0.001;
constexpr double kQuietShare = 0.2;

// What the hands of the quietest frames do between their neighbours: motion capture's hands stand, a webcam's
// tremble. Confidence has no say in it, so that doubt alone moves no event.
double smoothing_samples(const JointTrack& track) {
  std::vector<double> jitter;
  const auto hands = [&](int frame) {
    return track.position(frame, LeftWrist) + track.position(frame, RightWrist) -
           2.0 * track.position(frame, Pelvis);
  };
  for (int frame = 1; frame + 1 < track.frame_count(); ++frame)
    jitter.push_back(0.25 * glm::length(hands(frame - 1) - 2.0 * hands(frame) + hands(frame + 1)));
  const auto quiet =
      jitter.begin() + static_cast<std::ptrdiff_t>(kQuietShare * static_cast<double>(jitter.size()));
  std::nth_element(jitter.begin(), quiet, jitter.end());
  const double part = std::clamp((*quiet - kQuiet_m) / (kTrembling_m - kQuiet_m), 0.0, 1.0);
  return (kLeastSmoothing_s + part * (kMostSmoothing_s - kLeastSmoothing_s)) * kHandPathRate;
}

}  // namespace

HandPath make_hand_path(const JointTrack& track, const Sight& sight) {
  const JointTrack fine = track.resampled(kHandPathRate, track.time(0), track.duration());
  HandPath path;
  path.begin_s = fine.time(0);
  std::vector<double> torso;
  for (int i = 0; i < fine.frame_count(); ++i) {
    const Vec3 hands = 0.5 * (fine.position(i, LeftWrist) + fine.position(i, RightWrist));
    const Vec3& pelvis = fine.position(i, Pelvis);
    path.left_wrist.push_back(sight.seen(fine.position(i, LeftWrist) - pelvis));
    path.right_wrist.push_back(sight.seen(fine.position(i, RightWrist) - pelvis));
    path.left_confidence.push_back(fine.confidence(i, LeftWrist));
    path.right_confidence.push_back(fine.confidence(i, RightWrist));
    path.unweighted_hands.push_back(hands - pelvis);
    path.hands.push_back(sight.seen(hands - pelvis));
    path.height.push_back(path.hands.back().y);
    const Vec3 left = fine.position(i, LeftShoulder), right = fine.position(i, RightShoulder);
    path.shoulder_line.push_back(left - right);
    path.arms.push_back(hands - 0.5 * (left + right));
    path.left_arms.push_back(hands - 0.75 * left - 0.25 * right);
    path.right_arms.push_back(hands - 0.25 * left - 0.75 * right);
    torso.push_back(glm::distance(fine.position(i, Neck), fine.position(i, Pelvis)));
  }
  const double sigma = smoothing_samples(track);
  path.hands = smoothed(path.hands, sigma);
  path.unweighted_hands = smoothed(path.unweighted_hands, sigma);
  path.unweighted_speed = speed_of(path.unweighted_hands, kHandPathRate);
  path.left_wrist = smoothed(path.left_wrist, sigma);
  path.right_wrist = smoothed(path.right_wrist, sigma);
  path.height = smoothed(path.height, sigma);
  path.arms = smoothed(path.arms, sigma);
  path.left_arms = smoothed(path.left_arms, sigma);
  path.right_arms = smoothed(path.right_arms, sigma);
  path.shoulder_line = smoothed(path.shoulder_line, sigma);
  path.speed = speed_of(path.hands, kHandPathRate);
  path.torso_m = median(std::move(torso));
  return path;
}

HandPath make_putt_path(const JointTrack& track, const Sight& sight) {
  HandPath path = make_hand_path(track, sight);
  if (!sight.direction) return path;
  const Pendulum pendulum(putt_posture(track), sight);
  for (int i = 0; i < path.count(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    path.hands[k] = pendulum.hands(path.unweighted_hands[k], path.shoulder_line[k]);
  }
  path.hands = smoothed(path.hands, kPuttSmoothing_s * kHandPathRate);
  path.speed = speed_of(path.hands, kHandPathRate);
  return path;
}

std::vector<double> elevation_deg(const std::vector<Vec3>& arm) {
  std::vector<double> elevation;
  elevation.reserve(arm.size());
  for (const Vec3& a : arm) elevation.push_back(degrees_from_radians(std::atan2(a.y, std::hypot(a.x, a.z))));
  return elevation;
}

}  // namespace posecoach
