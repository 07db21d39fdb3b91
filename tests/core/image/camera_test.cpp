#include "core/image/camera.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace posecoach {
namespace {

PinholeCamera some_camera() {
  return make_camera_looking_at({1, 1.5, 4}, {0, 1, 0}, 0.7, 1280, 720);
}

TEST(Camera, sees_its_target_in_the_middle_and_what_is_above_it_above) {
  const PinholeCamera camera = some_camera();
  EXPECT_NEAR(glm::distance(*camera.project({0, 1, 0}), Vec2(640, 360)), 0, 1e-9);
  EXPECT_LT(camera.project({0, 1.2, 0})->y, 360);
  EXPECT_NEAR(glm::distance(camera.position(), Vec3(1, 1.5, 4)), 0, 1e-12);
  EXPECT_FALSE(camera.project({2, 2, 8}));
}

TEST(Camera, a_scaled_camera_sees_everything_at_scaled_places) {
  const PinholeCamera camera = some_camera(), half = scaled(camera, 0.5);
  EXPECT_EQ(half.width_px, 640);
  EXPECT_EQ(half.height_px, 360);
  for (const Vec3& point : {Vec3(0, 0, 0), Vec3(0.5, 1.7, -0.3)})
    EXPECT_NEAR(glm::distance(*half.project(point), 0.5 * *camera.project(point)), 0, 1e-9);
}

}  // namespace
}  // namespace posecoach
