// Joints of a motion by role, for checks of golf motions.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/motion/authored/authored_motion.h"
#include "core/motion/bundled_motion.h"

namespace posecoach {

inline Vec3 joint_at(const Motion& motion, int frame, HumanoidJoint role) {
  return motion.position(frame, motion.skeleton().find(role));
}

inline Vec3 hands_at(const Motion& motion, int frame) {
  return 0.5 * (joint_at(motion, frame, HumanoidJoint::LeftWrist) +
                joint_at(motion, frame, HumanoidJoint::RightWrist));
}

inline int frame_at(const Motion& motion, double time_s) {
  int best = 0;
  for (int frame = 0; frame < motion.frame_count(); ++frame)
    if (std::abs(to_seconds(motion.time(frame)) - time_s) < std::abs(to_seconds(motion.time(best)) - time_s))
      best = frame;
  return best;
}

inline int frame_at(const AuthoredMotion& authored, std::string_view event) {
  return frame_at(authored.motion, authored.time_of(event));
}

// Degrees on the ground of the line from the right to the left joint; positive when it opens to the left.
inline double turn_deg(const Motion& motion, int frame, HumanoidJoint left, HumanoidJoint right) {
  const Vec3 line = joint_at(motion, frame, left) - joint_at(motion, frame, right);
  return degrees_from_radians(std::atan2(-line.z, line.x));
}
inline double shoulder_turn_deg(const Motion& motion, int frame) {
  return turn_deg(motion, frame, HumanoidJoint::LeftShoulder, HumanoidJoint::RightShoulder);
}
inline double hip_turn_deg(const Motion& motion, int frame) {
  return turn_deg(motion, frame, HumanoidJoint::LeftHip, HumanoidJoint::RightHip);
}

inline double bend_deg(const Motion& motion, int frame, HumanoidJoint a, HumanoidJoint b, HumanoidJoint c) {
  const Vec3 upper = glm::normalize(joint_at(motion, frame, b) - joint_at(motion, frame, a));
  const Vec3 lower = glm::normalize(joint_at(motion, frame, c) - joint_at(motion, frame, b));
  return degrees_from_radians(std::acos(std::clamp(glm::dot(upper, lower), -1.0, 1.0)));
}

inline Vec3 middle(const Motion& motion, int frame, HumanoidJoint a, HumanoidJoint b) {
  return 0.5 * (joint_at(motion, frame, a) + joint_at(motion, frame, b));
}
inline Vec3 hips_at(const Motion& motion, int frame) {
  return middle(motion, frame, HumanoidJoint::LeftHip, HumanoidJoint::RightHip);
}
inline Vec3 torso_at(const Motion& motion, int frame) {
  return middle(motion, frame, HumanoidJoint::LeftShoulder, HumanoidJoint::RightShoulder) -
         hips_at(motion, frame);
}
inline double forward_bend_deg(const Motion& motion, int frame) {
  const Vec3 torso = torso_at(motion, frame);
  return degrees_from_radians(std::atan2(torso.z, torso.y));
}

}  // namespace posecoach
