#include "core/coaching/dtw.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace posecoach {
namespace {

std::vector<float> random_costs(std::mt19937& random, int rows, int columns) {
  std::uniform_real_distribution<float> uniform(0, 1);
  std::vector<float> costs(static_cast<std::size_t>(rows * columns));
  for (float& cost : costs) cost = uniform(random);
  return costs;
}

float at(const std::vector<float>& costs, int columns, int i, int j) {
  return costs[static_cast<std::size_t>(i * columns + j)];
}

// Every path there is, without dynamic programming.
double cheapest_by_trying_all(const std::vector<float>& costs, int rows, int columns, int i, int j) {
  const double here = static_cast<double>(at(costs, columns, i, j));
  if (i == rows - 1 && j == columns - 1) return here;
  double best = std::numeric_limits<double>::infinity();
  if (i + 1 < rows) best = std::min(best, cheapest_by_trying_all(costs, rows, columns, i + 1, j));
  if (j + 1 < columns) best = std::min(best, cheapest_by_trying_all(costs, rows, columns, i, j + 1));
  if (i + 1 < rows && j + 1 < columns)
    best = std::min(best, cheapest_by_trying_all(costs, rows, columns, i + 1, j + 1));
  return here + best;
}

double cost_along(const std::vector<float>& costs, int columns, const Warp& warp) {
  double sum = 0;
  for (const auto& [i, j] : warp.path) sum += static_cast<double>(at(costs, columns, i, j));
  return sum;
}

void expect_steps_of_one(const Warp& warp) {
  for (std::size_t k = 1; k < warp.path.size(); ++k) {
    const int di = warp.path[k].first - warp.path[k - 1].first;
    const int dj = warp.path[k].second - warp.path[k - 1].second;
    ASSERT_TRUE((di == 0 || di == 1) && (dj == 0 || dj == 1) && di + dj > 0) << "step " << k;
  }
}

PoseSequence random_walk(std::mt19937& random, int frames, int joints) {
  std::normal_distribution<float> normal(0, 0.02F);
  PoseSequence poses(frames, joints);
  for (int k = 0; k < joints; ++k) {
    float x = 0, y = 0, z = 0;
    for (int frame = 0; frame < frames; ++frame)
      poses.set(frame, k, x += normal(random), y += normal(random), z += normal(random));
  }
  return poses;
}

TEST(Dtw, finds_the_cheapest_of_all_paths) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 60; ++trial) {
    const int rows = 1 + static_cast<int>(random() % 6), columns = 1 + static_cast<int>(random() % 6);
    const std::vector<float> costs = random_costs(random, rows, columns);
    const Warp found = warp(costs, columns);
    EXPECT_NEAR(found.cost, cheapest_by_trying_all(costs, rows, columns, 0, 0), 1e-9);
    EXPECT_NEAR(found.cost, cost_along(costs, columns, found), 1e-9);
    EXPECT_EQ(found.path.front(), std::pair(0, 0));
    EXPECT_EQ(found.path.back(), std::pair(rows - 1, columns - 1));
    expect_steps_of_one(found);
  }
}

TEST(Dtw, with_open_ends_finds_the_coach_anywhere_inside_the_student) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 40; ++trial) {
    const int rows = 2 + static_cast<int>(random() % 5), columns = 1 + static_cast<int>(random() % 4);
    const std::vector<float> costs = random_costs(random, rows, columns);
    double best = std::numeric_limits<double>::infinity();
    for (int first = 0; first < rows; ++first)
      for (int last = first; last < rows; ++last) {
        const std::vector<float> part(costs.begin() + first * columns, costs.begin() + (last + 1) * columns);
        best = std::min(best, cheapest_by_trying_all(part, last - first + 1, columns, 0, 0));
      }
    const Warp found = warp(costs, columns, WarpEnds::OpenStudent);
    EXPECT_NEAR(found.cost, best, 1e-9);
    EXPECT_NEAR(found.cost, cost_along(costs, columns, found), 1e-9);
    EXPECT_EQ(found.path.front().second, 0);
    EXPECT_EQ(found.path.back().second, columns - 1);
  }
}

TEST(Dtw, is_symmetric_in_cost) {
  std::mt19937 random(3);
  const PoseSequence a = random_walk(random, 70, 5), b = random_walk(random, 45, 5);
  EXPECT_NEAR(warp(a, b).cost, warp(b, a).cost, 1e-6);
}

TEST(Dtw, pairs_equal_sequences_frame_by_frame_at_no_cost) {
  std::mt19937 random(4);
  const PoseSequence a = random_walk(random, 50, 20);
  const Warp found = warp(a, a);
  EXPECT_EQ(found.cost, 0);
  ASSERT_EQ(found.path.size(), 50U);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(found.path[static_cast<std::size_t>(i)], std::pair(i, i));
}

TEST(Dtw, prefers_advancing_both_when_all_costs_are_equal) {
  const Warp found = warp(std::vector<float>(12, 1.0F), 4);
  EXPECT_EQ(found.cost, 4);
  EXPECT_EQ(found.path.size(), 4U);
}

TEST(Dtw, costs_of_poses_are_summed_distances_in_any_number_of_frames) {
  std::mt19937 random(5);
  for (const int frames : {1, 15, 16, 17, 33}) {
    const PoseSequence a = random_walk(random, 9, 7), b = random_walk(random, frames, 7);
    const Warp found = warp(a, b);
    double sum = 0;
    for (const auto& [i, j] : found.path) sum += pair_cost(a, i, b, j);
    EXPECT_NEAR(found.cost, sum, 1e-5 * sum);
  }
}

TEST(Dtw, doubt_in_a_joint_moves_its_share_to_the_others_and_makes_no_pair_cheaper) {
  PoseSequence certain(1, 2), doubtful(1, 2), coach(1, 2);
  for (PoseSequence* poses : {&certain, &doubtful}) {
    const float weight = poses == &doubtful ? 0.1F : 1.0F;
    poses->set(0, 0, 0.1F, 0, 0, weight);
    poses->set(0, 1, 0, 0, 0.1F, weight);
  }
  EXPECT_NEAR(warp(certain, coach).cost, 0.2, 1e-6);
  EXPECT_NEAR(warp(doubtful, coach).cost, 0.2, 1e-6);
  EXPECT_NEAR(warp(coach, doubtful).cost, 0.2, 1e-6);
  doubtful.set(0, 1, 5, 0, 0, 0);  // not seen at all
  EXPECT_NEAR(warp(doubtful, coach).cost, 0.2, 1e-6);
  EXPECT_NEAR(warp(coach, doubtful).cost, 0.2, 1e-6);
}

TEST(Dtw, aligns_a_minute_at_120_fps_in_bounded_memory) {
  std::mt19937 random(6);
  const PoseSequence a = random_walk(random, 7200, 1);
  const Warp found = warp(a, a);
  EXPECT_EQ(found.cost, 0);
  EXPECT_EQ(found.path.size(), 7200U);
}

}  // namespace
}  // namespace posecoach
