#include "core/pipeline/placing.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace posecoach {

std::array<Vec3, kLandmarkCount> on_rays(const SeenPerson& person, double depth, const Intrinsics& camera) {
  std::array<Vec3, kLandmarkCount> points;
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    const double z = std::max(0.1, depth + person.world[i].position_m.z);
    const Vec2 ray = (person.image[i].position_px - camera.centre_px) / camera.focal_px;
    points[i] = {ray.x * z, ray.y * z, z};
  }
  return points;
}

double arms_legs_and_torso(const Skeleton& body) {
  double sum = 0;
  for (const HumanoidJoint role :
       {HumanoidJoint::Chest, HumanoidJoint::LeftElbow, HumanoidJoint::LeftWrist, HumanoidJoint::RightElbow,
        HumanoidJoint::RightWrist, HumanoidJoint::LeftKnee, HumanoidJoint::LeftAnkle,
        HumanoidJoint::RightKnee, HumanoidJoint::RightAnkle})
    sum += body.bone_length(body.find(role));
  return sum;
}

namespace {

double angle_deg(const Vec3& facing, const Vec3& to_camera) {
  const Vec3 level(to_camera.x, 0, to_camera.z);
  return degrees_from_radians(std::atan2(glm::length(glm::cross(facing, level)), glm::dot(facing, level)));
}

}  // namespace

Vec3 facing_in(const Motion& motion, int frame) {
  using enum HumanoidJoint;
  const auto at = [&](HumanoidJoint role) { return motion.position(frame, motion.skeleton().find(role)); };
  const Vec3 across = at(LeftHip) - at(RightHip) + at(LeftShoulder) - at(RightShoulder);
  const Vec3 front = glm::cross(across, Vec3(0, 1, 0));
  return glm::length(front) > 1e-9 ? glm::normalize(front) : Vec3(0);
}

View view_from(const Vec3& facing, const Vec3& to_camera) {
  const double angle = angle_deg(facing, to_camera);
  if (angle < 40) return View::FaceOn;
  return angle > 55 && angle < 125 ? View::DownTheLine : View::Between;
}

double off_square_deg(const Vec3& facing, const Vec3& to_camera) {
  const double angle = angle_deg(facing, to_camera);
  return std::min(angle, std::abs(angle - 90));
}

bool is_square(const Vec3& facing, const Vec3& to_camera) {
  // Simulated golfers before a square camera were seen within 8 degrees of it, before one 20 degrees off at
  // 11 or more.
  constexpr double kSquare_deg = 12;
  return off_square_deg(facing, to_camera) < kSquare_deg;
}

}  // namespace posecoach
