#include "core/motion/authored/key_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace posecoach {
namespace {

std::vector<CurveKey> random_keys(std::mt19937& random) {
  std::uniform_real_distribution<double> step(0.04, 0.6), value(-100, 100);
  std::vector<CurveKey> keys;
  double time = 0.3;
  for (int i = 0; i < 9; ++i, time += step(random)) keys.push_back({time, value(random)});
  return keys;
}

TEST(KeyCurve, goes_through_its_keys_and_stands_still_outside) {
  std::mt19937 random(1);
  for (int round = 0; round < 20; ++round) {
    const std::vector<CurveKey> keys = random_keys(random);
    const KeyCurve curve(keys);
    for (const CurveKey& key : keys) EXPECT_NEAR(curve.value(key.time_s), key.value, 1e-9);
    EXPECT_EQ(curve.value(-5), keys.front().value);
    EXPECT_EQ(curve.value(99), keys.back().value);
  }
}

TEST(KeyCurve, has_no_jump_in_velocity_or_acceleration) {
  std::mt19937 random(2);
  for (int round = 0; round < 20; ++round) {
    const std::vector<CurveKey> keys = random_keys(random);
    const KeyCurve curve(keys);
    const double h = 1e-5;
    const auto velocity = [&](double t) { return (curve.value(t + h) - curve.value(t - h)) / (2 * h); };
    const auto acceleration = [&](double t) { return (velocity(t + h) - velocity(t - h)) / (2 * h); };
    for (const CurveKey& key : keys) {
      const double t = key.time_s;
      EXPECT_NEAR(velocity(t - 4 * h), velocity(t + 4 * h), 10);
      const double scale = 1 + std::abs(acceleration(t - 0.01)) + std::abs(acceleration(t + 0.01));
      EXPECT_NEAR(acceleration(t - 4 * h), acceleration(t + 4 * h), 0.1 * scale);
    }
  }
}

TEST(KeyCurve, stands_still_for_an_instant_at_a_turning_point) {
  const std::vector<CurveKey> keys = {{0, 0}, {0.8, -90}, {1.05, 10}, {1.6, 100}};
  const KeyCurve curve(keys);
  EXPECT_NEAR((curve.value(0.8 + 1e-6) - curve.value(0.8 - 1e-6)) / 2e-6, 0, 1e-2);
  EXPECT_GT(curve.value(0.78), -90);
  EXPECT_GT(curve.value(0.82), -90);
}

TEST(KeyCurve, equal_keys_stay_nearly_level_beside_a_quick_neighbour) {
  const std::vector<CurveKey> keys = {{0, 5}, {0.9, 5}, {1.0, 40}};
  const KeyCurve curve(keys);
  for (double t = 0; t < 0.9; t += 0.01) EXPECT_NEAR(curve.value(t), 5, 1e-9);
}

TEST(KeyCurve, without_keys_is_zero) {
  EXPECT_EQ(KeyCurve().value(1), 0);
}

}  // namespace
}  // namespace posecoach
