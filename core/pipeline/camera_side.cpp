#include "core/pipeline/camera_side.h"

#include <glm/geometric.hpp>

namespace posecoach {

std::string_view to_string(View view) {
  switch (view) {
    case View::FaceOn:
      return "face-on";
    case View::DownTheLine:
      return "down-the-line";
    case View::Between:
      break;
  }
  return "between";
}

Viewpoint viewpoint_of(View view) {
  switch (view) {
    case View::FaceOn:
      return Viewpoint::FaceOn;
    case View::DownTheLine:
      return Viewpoint::DownTheLine;
    case View::Between:
      break;
  }
  return Viewpoint::Between;
}

Viewpoint judged_from(const CameraSide& camera) {
  return camera.is_square() ? viewpoint_of(camera.view) : Viewpoint::Between;
}

CameraSide camera_side(const Vec3& facing, const Vec3& to_camera) {
  const Vec3 left = glm::cross(Vec3(0, 1, 0), facing);
  const double to_left = degrees_from_radians(
      std::atan2(glm::dot(to_camera, left), glm::dot(to_camera, Vec3(facing.x, 0, facing.z))));
  const double to_front = 90 - std::abs(to_left);
  if (std::abs(to_left) <= std::abs(to_front))
    return {std::abs(to_left) <= kAside_deg ? View::FaceOn : View::Between, to_left};
  return {std::abs(to_front) <= kAside_deg ? View::DownTheLine : View::Between, to_front};
}

Vec3 facing_in(const Motion& motion, int frame) {
  using enum HumanoidJoint;
  const auto at = [&](HumanoidJoint role) { return motion.position(frame, motion.skeleton().find(role)); };
  const Vec3 across = at(LeftHip) - at(RightHip) + at(LeftShoulder) - at(RightShoulder);
  const Vec3 front = glm::cross(across, Vec3(0, 1, 0));
  return glm::length(front) > 1e-9 ? glm::normalize(front) : Vec3(0);
}

}  // namespace posecoach
