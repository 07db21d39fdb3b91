#include "core/vision/heatmap_refinement.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace posecoach {
namespace {

constexpr int kChannels = 2;

std::vector<float> make_cold_map() {
  return std::vector<float>(static_cast<std::size_t>(kHeatmapSize * kHeatmapSize * kChannels), -30.0F);
}

float& cell(std::vector<float>& map, int column, int row, int channel) {
  return map[static_cast<std::size_t>((row * kHeatmapSize + column) * kChannels + channel)];
}

TEST(HeatmapRefinement, a_cold_map_moves_nothing) {
  const auto map = make_cold_map();
  EXPECT_EQ(refined_by_heatmap({0.4, 0.6}, map, 0, kChannels), Vec2(0.4, 0.6));
}

TEST(HeatmapRefinement, one_warm_cell_nearby_attracts_the_point) {
  auto map = make_cold_map();
  cell(map, 22, 33, 1) = 20;
  const Vec2 moved = refined_by_heatmap({20.9 / 64, 32.1 / 64}, map, 1, kChannels);
  EXPECT_NEAR(moved.x, 22.0 / 64, 1e-9);
  EXPECT_NEAR(moved.y, 33.0 / 64, 1e-9);
  EXPECT_EQ(refined_by_heatmap({20.9 / 64, 32.1 / 64}, map, 0, kChannels), Vec2(20.9 / 64, 32.1 / 64));
}

TEST(HeatmapRefinement, a_warm_cell_beyond_the_window_does_not) {
  auto map = make_cold_map();
  cell(map, 24, 32, 0) = 20;
  EXPECT_EQ(refined_by_heatmap({20.5 / 64, 0.5}, map, 0, kChannels), Vec2(20.5 / 64, 0.5));
}

TEST(HeatmapRefinement, windows_end_at_the_edge_and_points_outside_stay) {
  auto map = make_cold_map();
  cell(map, 0, 0, 0) = 20;
  cell(map, 63, 63, 0) = 20;
  const Vec2 corner = refined_by_heatmap({0.001, 0.001}, map, 0, kChannels);
  EXPECT_NEAR(corner.x, 0, 1e-9);
  const Vec2 end = refined_by_heatmap({0.999, 0.999}, map, 0, kChannels);
  EXPECT_NEAR(end.y, 63.0 / 64, 1e-9);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Vec2& outside : {Vec2(-0.1, 0.5), Vec2(0.5, 1.0), Vec2(1e300, 0.5)})
    EXPECT_EQ(refined_by_heatmap(outside, map, 0, kChannels), outside);
  EXPECT_TRUE(std::isnan(refined_by_heatmap({nan, 0.5}, map, 0, kChannels).x));
}

}  // namespace
}  // namespace posecoach
