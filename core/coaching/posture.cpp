#include "core/coaching/posture.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace posecoach {
namespace {

using enum HumanoidJoint;

double angle_deg(const Vec3& a, const Vec3& b) {
  return degrees_from_radians(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

}  // namespace

Vec3 middle_of(const JointTrack& track, int frame, HumanoidJoint a, HumanoidJoint b) {
  return 0.5 * (track.position(frame, a) + track.position(frame, b));
}

Vec3 middle_of_shoulders(const JointTrack& track, int frame) {
  return middle_of(track, frame, LeftShoulder, RightShoulder);
}

Vec3 middle_of_hips(const JointTrack& track, int frame) {
  return middle_of(track, frame, LeftHip, RightHip);
}

double bend_deg(const JointTrack& track, int frame, HumanoidJoint above, HumanoidJoint joint,
                HumanoidJoint below) {
  const Vec3 middle = track.position(frame, joint);
  return angle_deg(middle - track.position(frame, above), track.position(frame, below) - middle);
}

double turn_deg(const JointTrack& track, int frame, HumanoidJoint left, HumanoidJoint right,
                const BodyAxes& axes) {
  const Vec3 line = in_axes(axes, track.position(frame, left) - track.position(frame, right));
  return degrees_from_radians(std::atan2(-line.z, line.x));
}

double tilt_deg(const JointTrack& track, int frame, HumanoidJoint left, HumanoidJoint right) {
  const Vec3 line = track.position(frame, left) - track.position(frame, right);
  return degrees_from_radians(std::atan2(line.y, std::hypot(line.x, line.z)));
}

double spine_forward_deg(const JointTrack& track, int frame, const BodyAxes& axes) {
  const Vec3 spine = in_axes(axes, middle_of_shoulders(track, frame) - middle_of_hips(track, frame));
  return degrees_from_radians(std::atan2(spine.z, spine.y));
}

double spine_side_deg(const JointTrack& track, int frame, const BodyAxes& axes) {
  const Vec3 spine = in_axes(axes, middle_of_shoulders(track, frame) - middle_of_hips(track, frame));
  return degrees_from_radians(std::atan2(-spine.x, spine.y));
}

double wrist_break_deg(const JointTrack& track, int frame, const BodyAxes& axes) {
  const Vec3 grip = in_axes(axes, track.position(frame, RightWrist) - track.position(frame, LeftWrist));
  const Vec3 forearm = in_axes(axes, track.position(frame, LeftWrist) - track.position(frame, LeftElbow));
  const double angle = std::atan2(grip.x, -grip.y) - std::atan2(forearm.x, -forearm.y);
  return degrees_from_radians(std::remainder(angle, 2 * kPi));
}

}  // namespace posecoach
