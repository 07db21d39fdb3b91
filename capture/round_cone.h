// The shapes of the simulated student: two balls and the cone that joins them, seen from a pinhole camera.
#pragma once

#include <array>
#include <vector>

#include "core/base/math.h"
#include "core/image/camera.h"
#include "core/image/frame.h"

namespace posecoach {

using SurfaceColour = std::array<float, 3>;  // red, green, blue in [0, 1], as shown

struct RoundCone {
  Vec3 begin, end;  // world, metres
  double begin_radius = 0, end_radius = 0;
  SurfaceColour colour{};
};

// A soft dark spot on the ground.
struct GroundShadow {
  Vec3 begin, end;  // the line under which it lies; heights do not count
  double radius = 0;
  double strength = 0;  // 0 to 1
};

struct ConeScene {
  std::vector<RoundCone> cones;  // at most 65534
  std::vector<GroundShadow> shadows;
};

// Grass and sky, without anybody on it: drawn once for a camera that stands still.
Image draw_ground_and_sky(const PinholeCamera& camera);

// Draws the scene over a copy of `background`, which must have the camera's size. Plain arithmetic and square
// roots only, so that the same scene gives the same pixels on every machine.
Image draw_scene(const ConeScene& scene, const PinholeCamera& camera, const Image& background);

}  // namespace posecoach
