#include "capture/round_cone.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <random>

namespace posecoach {
namespace {

PinholeCamera camera(int width = 160, int height = 120) {
  return make_camera_looking_at({0, 1, 4}, {0, 1, 0}, radians_from_degrees(40), width, height);
}

constexpr SurfaceColour kRed = {1, 0, 0};

bool is_red(const Image& image, int x, int y) {
  const std::uint8_t* pixel = image.pixel(x, y);
  return pixel[0] > 60 && pixel[1] < 20 && pixel[2] < 20;
}

Image draw(const RoundCone& cone, const PinholeCamera& view) {
  return draw_scene({{cone}, {}}, view, Image::black(view.width_px, view.height_px));
}

// The inside of a round cone is the union of the balls along its axis: a ray meets it where it passes near
// enough to one of them.
bool meets(const RoundCone& cone, const PinholeCamera& view, double x, double y, double margin) {
  const Vec3 eye = view.position();
  const Vec3 direction =
      glm::normalize(glm::transpose(view.rotation_camera_from_world) *
                     Vec3((x - view.centre_px.x) / view.focal_px, (y - view.centre_px.y) / view.focal_px, 1));
  for (int i = 0; i <= 400; ++i) {
    const double part = i / 400.0;
    const Vec3 centre = glm::mix(cone.begin, cone.end, part);
    const double radius = glm::mix(cone.begin_radius, cone.end_radius, part) + margin;
    const Vec3 to = centre - eye;
    if (glm::length(to - direction * glm::dot(to, direction)) < radius) return true;
  }
  return false;
}

TEST(RoundCone, covers_exactly_the_pixels_whose_rays_meet_it) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-0.8, 0.8), radius(0.02, 0.35);
  const PinholeCamera view = camera();
  for (int round = 0; round < 30; ++round) {
    const RoundCone cone = {{place(random), 1 + place(random), place(random)},
                            {place(random), 1 + place(random), place(random)},
                            radius(random),
                            radius(random),
                            kRed};
    const Image image = draw(cone, view);
    for (int y = 0; y < image.height; y += 2)
      for (int x = 0; x < image.width; x += 2) {
        if (meets(cone, view, x + 0.5, y + 0.5, -0.03)) {
          ASSERT_TRUE(is_red(image, x, y)) << round << " " << x << " " << y;
        }
        if (!meets(cone, view, x + 0.5, y + 0.5, 0.03)) {
          ASSERT_EQ(image.pixel(x, y)[0], 0) << round << " " << x << " " << y;
        }
      }
  }
}

TEST(RoundCone, nearer_one_hides_the_other) {
  const PinholeCamera view = camera();
  const RoundCone near = {{0, 1, 1}, {0, 1, 1}, 0.1, 0.1, kRed},
                  far = {{0, 1, 0}, {0, 1, 0}, 0.5, 0.5, {0, 1, 0}};
  for (const auto& cones : {std::vector{near, far}, std::vector{far, near}}) {
    const Image image = draw_scene({cones, {}}, view, Image::black(view.width_px, view.height_px));
    EXPECT_TRUE(is_red(image, 80, 60));
    EXPECT_GT(image.pixel(80, 45)[1], 60);
  }
}

TEST(RoundCone, behind_the_camera_is_not_drawn) {
  const PinholeCamera view = camera();
  EXPECT_EQ(draw({{0, 1, 6}, {0, 1.5, 7}, 0.5, 0.2, kRed}, view).rgb, Image::black(160, 120).rgb);
}

TEST(RoundCone, edges_are_soft) {
  const Image image = draw({{0, 1, 0}, {0.4, 1.3, 0}, 0.2, 0.1, kRed}, camera());
  int between = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3)
    between += image.rgb[i] > 15 && image.rgb[i] < 70 ? 1 : 0;
  EXPECT_GT(between, 20);
}

TEST(GroundAndSky, sky_is_above_the_grass) {
  const Image image = draw_ground_and_sky(camera());
  EXPECT_GT(image.pixel(80, 5)[2], image.pixel(80, 5)[0]);
  EXPECT_GT(image.pixel(80, 115)[1], image.pixel(80, 115)[2] + 20);
}

TEST(GroundShadow, darkens_the_ground_below_only) {
  const PinholeCamera view = camera();
  const Image ground = draw_ground_and_sky(view);
  const Image shaded = draw_scene({{}, {{{0, 0, 1}, {0, 0, 1}, 0.3, 0.6}}}, view, ground);
  const auto px = view.project({0, 0, 1}).value();
  const int x = static_cast<int>(px.x), y = std::min(119, static_cast<int>(px.y));
  EXPECT_LT(shaded.pixel(x, y)[1], ground.pixel(x, y)[1] * 0.7);
  EXPECT_EQ(shaded.pixel(10, 10)[1], ground.pixel(10, 10)[1]);
  EXPECT_EQ(shaded.pixel(5, y)[1], ground.pixel(5, y)[1]);
}

}  // namespace
}  // namespace posecoach
