#include "core/body/two_bone_ik.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

namespace posecoach {
namespace {

TEST(TwoBoneIk, reaches_every_target_within_reach_with_exact_lengths) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 500; ++i) {
    const Vec3 root(uniform(random), uniform(random), uniform(random));
    Vec3 direction(uniform(random), uniform(random), uniform(random));
    if (glm::length(direction) < 0.1) continue;
    const Vec3 target = root + glm::normalize(direction) * (0.06 + 0.26 * (uniform(random) + 1));
    const auto solved = solve_two_bones(root, target, root + Vec3(0, 0, 1), 0.3, 0.28);
    EXPECT_NEAR(glm::distance(solved.end, target), 0, 1e-9);
    EXPECT_NEAR(glm::distance(solved.middle, root), 0.3, 1e-9);
    EXPECT_NEAR(glm::distance(solved.middle, solved.end), 0.28, 1e-9);
    EXPECT_NEAR(solved.deficit, 0, 1e-9);
  }
}

TEST(TwoBoneIk, a_target_out_of_reach_is_approached_and_the_deficit_told) {
  const auto solved = solve_two_bones({0, 0, 0}, {2, 0, 0}, {0, 0, 1}, 0.3, 0.3);
  EXPECT_NEAR(solved.deficit, 1.4, 1e-12);
  EXPECT_NEAR(glm::distance(solved.end, Vec3(0.6, 0, 0)), 0, 1e-9);
}

TEST(TwoBoneIk, bends_towards_the_pole) {
  EXPECT_GT(solve_two_bones({0, 0, 0}, {0.4, 0, 0}, {0, 0, 5}, 0.3, 0.3).middle.z, 0);
  EXPECT_LT(solve_two_bones({0, 0, 0}, {0.4, 0, 0}, {0, 0, -5}, 0.3, 0.3).middle.z, 0);
}

TEST(SwingBetween, turns_one_direction_into_the_other_even_when_opposite) {
  for (const auto& [a, b] :
       {std::pair(Vec3(1, 2, 3), Vec3(-3, 1, 0)), std::pair(Vec3(1, 0, 0), Vec3(-2, 0, 0))})
    EXPECT_NEAR(glm::distance(swing_between(a, b) * glm::normalize(a), glm::normalize(b)), 0, 1e-6);
}

}  // namespace
}  // namespace posecoach
