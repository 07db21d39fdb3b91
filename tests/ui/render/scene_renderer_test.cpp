#include "ui/render/scene_renderer.h"

#include <gtest/gtest.h>

#include "core/body/standard_body.h"
#include "tests/support/image_compare.h"
#include "tests/support/offscreen.h"
#include "ui/render/figure.h"

namespace posecoach {
namespace {

const Colour kBlack = colour_from_hex(0);

Scene black_scene() {
  Scene scene;
  scene.background_top = scene.background_bottom = kBlack;
  return scene;
}

Figure ball(const Vec3& centre, double radius) {
  Figure figure;
  figure.capsules.push_back({centre, centre, radius, radius, colour_from_hex(0xFFFFFF)});
  return figure;
}

// Middle of all pixels that differ from black, in image coordinates (pixel centres at + 0.5).
Vec2 centroid(const Image& image) {
  Vec2 sum(0);
  double count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (image.pixel(x, y)[1] > 20) {
        sum += Vec2(x + 0.5, y + 0.5);
        ++count;
      }
  return count > 0 ? sum / count : Vec2(-1);
}

int count_lit(const Image& image) {
  int count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (image.pixel(x, y)[1] > 20) ++count;
  return count;
}

TEST(SceneRenderer, a_joint_lands_where_the_pinhole_camera_says) {
  PinholeCamera camera = make_camera_looking_at({1.5, 1.7, 4}, {0.2, 0.9, -0.3}, 0.7, 240, 180);
  camera.centre_px += Vec2(13, -9);  // off centre, so that no symmetry hides a flip
  for (const Vec3& joint :
       {Vec3(0, 0.9, 0), Vec3(0.7, 1.4, 0.2), Vec3(-0.6, 0.3, -0.5), Vec3(0.1, 1.6, 0.9)}) {
    Scene scene = black_scene();
    scene.figures.push_back(ball(joint, 0.03));
    const Vec2 expected = camera.project(joint).value();
    const Vec2 seen = centroid(render_image(scene, camera));
    EXPECT_NEAR(seen.x, expected.x, 0.5) << joint.x << ' ' << joint.y << ' ' << joint.z;
    EXPECT_NEAR(seen.y, expected.y, 0.5) << joint.x << ' ' << joint.y << ' ' << joint.z;
  }
}

TEST(SceneRenderer, a_ball_is_as_large_as_perspective_makes_it) {
  const PinholeCamera camera = make_camera_looking_at({0, 1, 3}, {0, 1, 0}, 0.8, 200, 200);
  Scene scene = black_scene();
  scene.figures.push_back(ball({0, 1, 0}, 0.3));
  const double radius_px = camera.focal_px * 0.3 / std::sqrt(3.0 * 3.0 - 0.3 * 0.3);
  const double seen_px = std::sqrt(count_lit(render_image(scene, camera)) / kPi);
  EXPECT_NEAR(seen_px, radius_px, 0.6);  // pixels at the rim count as whole ones
}

TEST(SceneRenderer, picture_comes_back_as_it_went_in) {
  auto picture = std::make_shared<Image>(Image::black(37, 23));
  for (std::size_t i = 0; i < picture->rgb.size(); ++i) picture->rgb[i] = static_cast<std::uint8_t>(i * 7);
  Scene scene;
  scene.picture = picture;
  const PinholeCamera camera = make_camera_looking_at({0, 1, 3}, {0, 1, 0}, 0.8, 37, 23);
  EXPECT_EQ(render_image(scene, camera).rgb, picture->rgb);
}

TEST(SceneRenderer, scaled_picture_keeps_its_top_on_top) {
  auto picture = std::make_shared<Image>(Image::black(40, 40));
  for (int x = 0; x < 40; ++x) picture->pixel(x, 3)[0] = 255;
  Scene scene;
  scene.picture = picture;
  const Image image = render_image(scene, make_camera_looking_at({0, 1, 3}, {0, 1, 0}, 0.8, 80, 80));
  EXPECT_GT(image.pixel(40, 7)[0], 150);
  EXPECT_LT(image.pixel(40, 72)[0], 10);
}

TEST(SceneRenderer, size_follows_the_camera_from_picture_to_picture) {
  for (const auto& [width, height] : {std::pair(64, 48), std::pair(200, 120), std::pair(48, 64)}) {
    const PinholeCamera camera = make_camera_looking_at({0, 1, 3}, {0, 1, 0}, 0.8, width, height);
    Scene scene = black_scene();
    scene.figures.push_back(ball({0, 1, 0}, 0.2));
    const Image image = render_image(scene, camera);
    EXPECT_EQ(image.width, width);
    EXPECT_EQ(image.height, height);
    const Vec2 seen = centroid(image);
    EXPECT_NEAR(seen.x, 0.5 * width, 0.5);
    EXPECT_NEAR(seen.y, 0.5 * height, 0.5);
  }
}

TEST(SceneRenderer, bodies_behind_or_around_the_camera_are_no_harm) {
  const PinholeCamera camera = make_camera_looking_at({0, 1, 3}, {0, 1, 0}, 0.8, 60, 60);
  Scene scene = black_scene();
  scene.figures.push_back(ball({0, 1, 8}, 0.2));
  EXPECT_EQ(count_lit(render_image(scene, camera)), 0);
  scene.figures[0] = ball({0, 1, 3}, 0.5);
  render_image(scene, camera);
  scene.figures[0] = ball({30, 1, 0}, 0.5);
  EXPECT_EQ(count_lit(render_image(scene, camera)), 0);
}

TEST(SceneRenderer, see_through_figure_is_even_where_its_bones_overlap) {
  Figure figure = ball({0, 1, 0}, 0.3);
  figure.capsules.push_back(figure.capsules[0]);
  figure.opacity = 0.5;
  const PinholeCamera camera = make_camera_looking_at({0, 1, 3}, {0, 1, 0}, 0.8, 60, 60);
  Scene once = black_scene(), twice = black_scene();
  twice.figures.push_back(figure);
  figure.capsules.pop_back();
  once.figures.push_back(figure);
  EXPECT_EQ(render_image(once, camera).rgb, render_image(twice, camera).rgb);
}

TEST(SceneRenderer, the_nearer_limb_covers_the_farther) {
  Figure figure = ball({0, 1, 0.5}, 0.1);
  figure.capsules[0].colour = colour_from_hex(0xFF0000);
  figure.capsules.push_back({{0, 1, -0.5}, {0, 1, -0.5}, 0.3, 0.3, colour_from_hex(0x00FF00)});
  const PinholeCamera camera = make_camera_looking_at({0, 1, 3}, {0, 1, 0}, 0.8, 60, 60);
  for (int order = 0; order < 2; ++order) {
    Scene scene = black_scene();
    scene.figures.push_back(figure);
    const Image image = render_image(scene, camera);
    EXPECT_GT(image.pixel(30, 30)[0], image.pixel(30, 30)[1] + 50);
    std::swap(figure.capsules[0], figure.capsules[1]);
  }
}

TEST(SceneRenderer, box_covers_exactly_its_pixels) {
  Scene scene = black_scene();
  scene.add(make_box({10, 20}, {30, 5}, 0, colour_from_hex(0xFFFFFF)));
  const Image image = render_image(scene, make_camera_looking_at({0, 1, 3}, {0, 1, 0}, 0.8, 64, 64));
  EXPECT_EQ(count_lit(image), 150);
  EXPECT_EQ(image.pixel(10, 20)[0], 255);
  EXPECT_EQ(image.pixel(39, 24)[0], 255);
  EXPECT_EQ(image.pixel(40, 24)[0], 0);
  EXPECT_EQ(image.pixel(39, 25)[0], 0);
}

TEST(SceneRenderer, text_stands_on_its_base_line_and_is_as_wide_as_measured) {
  Scene scene = black_scene();
  Text text;
  text.utf8 = "HEIM";
  text.baseline = {20, 40};
  text.size_px = 24;
  scene.add(text);
  const Image image = render_image(scene, make_camera_looking_at({0, 1, 3}, {0, 1, 0}, 0.8, 128, 64));
  int left = 999, right = -1, top = 999, bottom = -1;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (image.pixel(x, y)[0] > 100) {
        left = std::min(left, x);
        right = std::max(right, x);
        top = std::min(top, y);
        bottom = std::max(bottom, y);
      }
  EXPECT_EQ(bottom, 39);
  EXPECT_NEAR(bottom - top + 1, cap_height_px(24), 1);
  const double width = text_width_px("HEIM", FontWeight::Medium, 24);
  EXPECT_LE(right - left + 1, width);
  EXPECT_GE(right - left + 1, width - 6);  // the first and last letter's own margins
  EXPECT_NEAR(left, 21, 2);
}

// The standard body from the front and from its left side.
TEST(SceneRenderer, golden_skeletons) {
  const Skeleton body = make_standard_body();
  Scene scene;
  scene.floor = Floor{};
  scene.figures.push_back(make_figure({body, body.rest_positions()}, student_style(Palette::RedGreen)));
  EXPECT_TRUE(
      matches_golden(render_image(scene, make_camera_looking_at({0, 1.1, 4}, {0, 0.9, 0}, 0.55, 256, 256)),
                     "skeleton_front"));
  EXPECT_TRUE(
      matches_golden(render_image(scene, make_camera_looking_at({3.6, 1.5, 0.8}, {0, 0.9, 0}, 0.6, 192, 256)),
                     "skeleton_side"));
}

TEST(SceneRenderer, golden_colour_blind_pair) {
  const Skeleton body = make_standard_body();
  std::vector<Vec3> beside(body.rest_positions().begin(), body.rest_positions().end());
  for (Vec3& p : beside) p += Vec3(0.14, 0, -0.1);
  Scene scene;
  scene.figures.push_back(make_figure({body, beside}, coach_style(Palette::ColourBlindSafe)));
  scene.figures.push_back(
      make_figure({body, body.rest_positions()}, student_style(Palette::ColourBlindSafe)));
  EXPECT_TRUE(
      matches_golden(render_image(scene, make_camera_looking_at({0, 1.1, 4}, {0, 0.9, 0}, 0.55, 256, 256)),
                     "colour_blind_pair"));
}

TEST(SceneRenderer, golden_text_and_shapes) {
  Scene scene;
  Box panel = make_box({8, 8}, {240, 112}, 12, colour_from_hex(0x11161D).with_alpha(0.8F));
  panel.border = 1;
  panel.border_colour = colour_from_hex(0xFFFFFF).with_alpha(0.2F);
  scene.add(panel);
  double y = 34;
  for (const double size : {11.0, 14.0, 17.0}) {
    Text text;
    text.utf8 = "Score 87 % – Über ±0.5 s";
    text.baseline = {20, y};
    text.size_px = size;
    text.weight = size > 15 ? FontWeight::Bold : FontWeight::Medium;
    scene.add(text);
    y += 1.5 * size + 6;
  }
  scene.add(make_line({20, 108}, {120, 96}, 3, colour_from_hex(0x2FBF71)));
  scene.add(make_disc({140, 100}, 7, colour_from_hex(0xF0443E)));
  Box glow = make_disc({180, 100}, 6, colour_from_hex(0x2F8FE0));
  glow.softness = 8;
  scene.add(glow);
  EXPECT_TRUE(matches_golden(render_image(scene, make_camera_looking_at({0, 1, 3}, {0, 1, 0}, 0.8, 256, 128)),
                             "text_and_shapes"));
}

}  // namespace
}  // namespace posecoach
