// A pinhole camera: from world points (metres, +Y up) to pixels (origin top left, +Y down). The camera itself
// looks along its +Z, with +X right and +Y down in the picture.
#pragma once

#include <optional>

#include "core/base/math.h"

namespace posecoach {

struct PinholeCamera {
  int width_px = 0;
  int height_px = 0;
  double focal_px = 1;
  Vec2 centre_px;
  Mat3 rotation_camera_from_world{1.0};
  Vec3 translation_camera_from_world;

  Vec3 camera_from_world(const Vec3& world) const {
    return rotation_camera_from_world * world + translation_camera_from_world;
  }
  Vec3 position() const {
    return -(glm::transpose(rotation_camera_from_world) * translation_camera_from_world);
  }
  // Nothing for points behind the camera.
  std::optional<Vec2> project(const Vec3& world) const;
};

// The same camera with a picture `factor` times as large.
PinholeCamera scaled(const PinholeCamera& camera, double factor);

// A camera at `eye` that looks at `target` with the world's up upwards; `vertical_view_angle` in radians.
PinholeCamera make_camera_looking_at(const Vec3& eye, const Vec3& target, double vertical_view_angle,
                                     int width_px, int height_px);

}  // namespace posecoach
