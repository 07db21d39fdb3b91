#include "core/image/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/assert.h"

namespace posecoach {

std::optional<Vec2> PinholeCamera::project(const Vec3& world) const {
  const Vec3 p = camera_from_world(world);
  if (p.z <= 1e-6) return std::nullopt;
  return Vec2(focal_px * p.x / p.z + centre_px.x, focal_px * p.y / p.z + centre_px.y);
}

PinholeCamera scaled(const PinholeCamera& camera, double factor) {
  POSECOACH_ASSERT(factor > 0);
  PinholeCamera other = camera;
  other.width_px = std::max(1, static_cast<int>(std::lround(factor * camera.width_px)));
  other.height_px = std::max(1, static_cast<int>(std::lround(factor * camera.height_px)));
  other.focal_px *= factor;
  other.centre_px *= factor;
  return other;
}

PinholeCamera make_camera_looking_at(const Vec3& eye, const Vec3& target, double vertical_view_angle,
                                     int width_px, int height_px) {
  POSECOACH_ASSERT(width_px > 0 && height_px > 0 && vertical_view_angle > 0);
  const Vec3 forward = glm::normalize(target - eye);
  const Vec3 right = glm::normalize(glm::cross(forward, Vec3(0, 1, 0)));
  const Vec3 down = glm::cross(forward, right);
  PinholeCamera camera;
  camera.width_px = width_px;
  camera.height_px = height_px;
  camera.focal_px = 0.5 * height_px / std::tan(0.5 * vertical_view_angle);
  camera.centre_px = {0.5 * width_px, 0.5 * height_px};
  camera.rotation_camera_from_world = glm::transpose(Mat3(right, down, forward));
  camera.translation_camera_from_world = -(camera.rotation_camera_from_world * eye);
  return camera;
}

}  // namespace posecoach
