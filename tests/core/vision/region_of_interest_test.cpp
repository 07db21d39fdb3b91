#include "core/vision/region_of_interest.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

#include "core/vision/letterbox.h"

namespace posecoach {
namespace {

TEST(RegionOfInterest, an_upright_person_has_an_upright_region) {
  const auto region = region_from_points({100, 200}, {100, 120});
  EXPECT_NEAR(region.rotation, 0, 1e-12);
  EXPECT_NEAR(region.size_px, 1.25 * 160, 1e-9);
  EXPECT_NEAR(region.to_picture({0, 0}).x, 0, 1e-9);
  EXPECT_NEAR(region.to_picture({0, 0}).y, 100, 1e-9);
  EXPECT_NEAR(region.to_picture({1, 1}).x, 200, 1e-9);
}

TEST(RegionOfInterest, the_scale_point_lies_straight_above_the_centre_whatever_the_turn) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> number(-500, 500);
  for (int i = 0; i < 200; ++i) {
    const Vec2 hip(number(random), number(random));
    const Vec2 scale(number(random), number(random));
    const auto region = region_from_points(hip, scale);
    EXPECT_GE(region.rotation, -kPi);
    EXPECT_LT(region.rotation, kPi);
    EXPECT_NEAR(glm::distance(region.to_picture({0.5, 0.5}), hip), 0, 1e-9);
    // Half the side is 1.25 times the distance of the two points.
    EXPECT_NEAR(glm::distance(region.to_picture({0.5, 0.5 - 0.5 / 1.25}), scale), 0, 1e-6);
  }
}

TEST(RegionOfInterest, its_square_is_square_and_not_mirrored) {
  const CropSquare square = region_from_points({10, 20}, {40, -30}).square();
  EXPECT_NEAR(glm::dot(square.across_px, square.down_px), 0, 1e-9);
  EXPECT_NEAR(glm::length(square.across_px), glm::length(square.down_px), 1e-9);
  EXPECT_GT(square.across_px.x * square.down_px.y - square.across_px.y * square.down_px.x, 0);
}

TEST(Letterbox, there_and_back_is_the_same_point) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(0, 1);
  for (const auto& [width, height] : {std::pair{1920, 1080}, {354, 492}, {500, 500}, {3, 4000}}) {
    const Letterbox letterbox(width, height);
    for (int i = 0; i < 50; ++i) {
      const Vec2 at_px(number(random) * width, number(random) * height);
      EXPECT_NEAR(glm::distance(letterbox.to_picture(letterbox.from_picture(at_px)), at_px), 0, 1e-9);
      EXPECT_NEAR(glm::distance(letterbox.square().at(letterbox.from_picture(at_px)), at_px), 0, 1e-9);
    }
  }
}

TEST(Letterbox, bars_are_equal_at_both_sides) {
  const Letterbox letterbox(200, 100);
  EXPECT_EQ(letterbox.from_picture({0, 0}), Vec2(0, 0.25));
  EXPECT_EQ(letterbox.from_picture({200, 100}), Vec2(1, 0.75));
}

}  // namespace
}  // namespace posecoach
