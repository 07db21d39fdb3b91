#include <gtest/gtest.h>

#include <random>

#include "core/vision/landmark_smoother.h"

namespace posecoach {
namespace {

TEST(OneEuroFilter, a_constant_stays_what_it_is_at_any_frame_rate) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> step(1e-4, 0.5);
  OneEuroFilter filter({0.05, 80, 1});
  double time_s = 0;
  for (int i = 0; i < 100; ++i, time_s += step(random))
    EXPECT_NEAR(filter.filter(media_time_from_seconds(time_s), 12.5, 0.01), 12.5, 1e-9);
}

TEST(OneEuroFilter, without_speed_it_is_the_textbook_low_pass) {
  OneEuroFilter filter({2, 0, 1});
  filter.filter(media_time_from_seconds(0), 0, 1);
  const double frequency = 25;
  const double share = 1 / (1 + frequency / (2 * kPi * 2));
  double expected = 0;
  for (int i = 1; i < 30; ++i) {
    expected += share * (1 - expected);
    EXPECT_NEAR(filter.filter(media_time_from_seconds(i / frequency), 1, 1), expected, 1e-9);
  }
}

TEST(OneEuroFilter, fast_motion_passes_and_slow_motion_is_held_back) {
  const auto lag_after_step = [](double speed_weight) {
    OneEuroFilter filter({0.05, speed_weight, 1});
    double last = 0;
    for (int i = 0; i < 5; ++i) last = filter.filter(media_time_from_seconds(i / 30.0), i == 0 ? 0 : 1, 1);
    return 1 - last;
  };
  EXPECT_GT(lag_after_step(0), 0.9);
  EXPECT_LT(lag_after_step(80), 0.05);
}

TEST(OneEuroFilter, the_result_stays_between_what_was_and_what_is) {
  std::mt19937 random(9);
  std::normal_distribution<double> noise(0, 10);
  OneEuroFilter filter({0.05, 80, 1});
  double before = filter.filter(MediaTime(), 0, 1);
  for (int i = 1; i < 300; ++i) {
    const double value = noise(random);
    const double smooth = filter.filter(media_time_from_seconds(i / 30.0), value, 0.01);
    EXPECT_GE(smooth, std::min(before, value) - 1e-9);
    EXPECT_LE(smooth, std::max(before, value) + 1e-9);
    before = smooth;
  }
}

TEST(OneEuroFilter, a_time_that_does_not_increase_passes_and_leaves_no_trace) {
  OneEuroFilter with({0.1, 1, 1});
  OneEuroFilter without({0.1, 1, 1});
  for (int i = 0; i < 10; ++i) {
    const auto time = media_time_from_seconds(i / 30.0);
    EXPECT_EQ(with.filter(time, i, 1), without.filter(time, i, 1));
    EXPECT_EQ(with.filter(time, 999, 1), 999);
  }
}

SeenPerson make_person(double offset, double visibility) {
  SeenPerson person;
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    const auto number = static_cast<double>(i);
    person.image[i] = {{100 + number + offset, 200 - number}, visibility};
    person.world[i] = {{0.1 * number, offset / 100, -0.1}, visibility};
  }
  return person;
}

TEST(LandmarkSmoother, a_still_person_is_not_changed) {
  LandmarkSmoother smoother;
  const SeenPerson person = make_person(0, 0.7);
  for (int i = 0; i < 20; ++i) {
    const SeenPerson smooth = smoother.smooth(media_time_from_seconds(i / 30.0), person, 300);
    for (std::size_t k = 0; k < kLandmarkCount; ++k) {
      EXPECT_NEAR(smooth.image[k].position_px.x, person.image[k].position_px.x, 1e-9);
      EXPECT_NEAR(smooth.world[k].position_m.x, person.world[k].position_m.x, 1e-9);
      EXPECT_NEAR(smooth.image[k].visibility, 0.7, 1e-9);
    }
  }
}

TEST(LandmarkSmoother, visibility_takes_a_tenth_of_what_is_new_in_both_spaces) {
  LandmarkSmoother smoother;
  smoother.smooth(media_time_from_seconds(0), make_person(0, 1), 300);
  const SeenPerson smooth = smoother.smooth(media_time_from_seconds(0.1), make_person(0, 0), 300);
  EXPECT_NEAR(smooth.image[0].visibility, 0.9, 1e-12);
  EXPECT_NEAR(smooth.world[0].visibility, 0.9, 1e-12);
}

TEST(LandmarkSmoother, after_a_reset_the_next_person_owes_nothing_to_the_last) {
  LandmarkSmoother smoother;
  smoother.smooth(media_time_from_seconds(0), make_person(0, 1), 300);
  smoother.reset();
  const SeenPerson next = make_person(50, 0.2);
  const SeenPerson smooth = smoother.smooth(media_time_from_seconds(0.1), next, 300);
  EXPECT_EQ(smooth.image[3].position_px, next.image[3].position_px);
  EXPECT_EQ(smooth.world[3].position_m, next.world[3].position_m);
  EXPECT_EQ(smooth.image[3].visibility, 0.2);
}

}  // namespace
}  // namespace posecoach
