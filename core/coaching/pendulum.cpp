#include "core/coaching/pendulum.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/coaching/body_axes.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

// Below this the turn of the shoulder line is hardly seen either.
constexpr double kLeastSeen = 0.3;
constexpr double kLeastWidth_m = 0.1;

Vec3 level_direction(const Vec3& v) {
  const Vec3 level(v.x, 0, v.z);
  const double length = glm::length(level);
  return length > 1e-6 ? level / length : Vec3(1, 0, 0);
}

}  // namespace

PuttPosture putt_posture(const JointMoment& moment) {
  const Vec3 across = moment.at(LeftShoulder) - moment.at(RightShoulder);
  const Vec3 shoulders = moment.middle(LeftShoulder, RightShoulder);
  PuttPosture posture;
  posture.left =
      level_direction(level_direction(across) + level_direction(moment.at(LeftHip) - moment.at(RightHip)) +
                      level_direction(moment.at(LeftAnkle) - moment.at(RightAnkle)));
  posture.spine = shoulders - moment.middle(LeftHip, RightHip);
  posture.arms = moment.middle(LeftWrist, RightWrist) - shoulders;
  posture.shoulder_width_m = glm::length(across);
  return posture;
}

PuttPosture between(const PuttPosture& from, const PuttPosture& to, double part) {
  return {level_direction(glm::mix(from.left, to.left, part)), glm::mix(from.spine, to.spine, part),
          glm::mix(from.arms, to.arms, part),
          from.shoulder_width_m + part * (to.shoulder_width_m - from.shoulder_width_m)};
}

PuttPosture putt_posture(const JointTrack& track) {
  PuttPosture mean;
  mean.left = body_axes(track, track.time(0), track.duration()).left;
  const double part = 1.0 / track.frame_count();
  for (int frame = 0; frame < track.frame_count(); ++frame) {
    const auto at = [&](HumanoidJoint joint) { return track.position(frame, joint); };
    const Vec3 shoulders = 0.5 * (at(LeftShoulder) + at(RightShoulder));
    mean.spine += part * (shoulders - 0.5 * (at(LeftHip) + at(RightHip)));
    mean.arms += part * (0.5 * (at(LeftWrist) + at(RightWrist)) - shoulders);
    mean.shoulder_width_m += part * glm::distance(at(LeftShoulder), at(RightShoulder));
  }
  return mean;
}

Pendulum::Pendulum(const PuttPosture& posture, const Sight& sight) : sight_(sight) {
  if (!sight.direction) return;
  const Vec3& along = *sight.direction;
  const double length = glm::length(posture.spine);
  if (length < 1e-6) return;
  const Vec3 spine = posture.spine / length;
  // Turning about the spine by a small angle moves the left shoulder this way, and the hands to the left.
  const Vec3 rocks = glm::cross(spine, posture.left);
  const Vec3 seen = rocks - glm::dot(rocks, along) * along;
  const double swings_m = glm::dot(glm::cross(spine, posture.arms), posture.left);
  const double seen_part = glm::length(seen);
  if (seen_part < kLeastSeen || swings_m <= 0) return;
  const double hidden = glm::dot(along, posture.left);
  model_share_ *= 1 - hidden * hidden;
  way_from_shoulders_ =
      hidden * swings_m / std::max(posture.shoulder_width_m, kLeastWidth_m) / (seen_part * seen_part) * seen;
}

Vec3 Pendulum::hands(const Vec3& hands, const Vec3& shoulder_line) const {
  if (!sight_.direction) return hands;
  const Vec3& along = *sight_.direction;
  const double depth = glm::dot(hands, along);
  return hands + (model_share_ * depth + glm::dot(shoulder_line, way_from_shoulders_) - depth) * along;
}

}  // namespace posecoach
