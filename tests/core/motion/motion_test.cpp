#include "core/motion/motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/body/forward_kinematics.h"
#include "core/body/standard_body.h"

namespace posecoach {
namespace {

std::vector<MediaTime> times_at(std::initializer_list<double> seconds) {
  std::vector<MediaTime> times;
  for (double s : seconds) times.push_back(media_time_from_seconds(s));
  return times;
}

Motion turning_motion() {
  const Skeleton body = make_standard_body();
  const auto joints = static_cast<std::size_t>(body.size());
  std::vector<Quat> rotations(3 * joints, Quat(1, 0, 0, 0));
  for (std::size_t frame = 0; frame < 3; ++frame)
    for (std::size_t j = 0; j < joints; ++j)
      rotations[frame * joints + j] =
          glm::angleAxis(0.1 * static_cast<double>(frame * j % 7), Vec3(0.6, 0, 0.8));
  return Motion::from_rotations(body, times_at({0, 0.5, 1.5}), {{0, 1, 0}, {0.5, 1, 0}, {1, 1, 0.5}},
                                rotations)
      .value();
}

TEST(Motion, rejects_no_frames_standing_time_and_numbers_that_are_not_finite) {
  const Skeleton point = Skeleton::make({{"root", kNoJoint, {}, {}}}).value();
  EXPECT_EQ(Motion::from_positions(point, {}, {}).error().code, ErrorCode::Incomplete);
  EXPECT_FALSE(Motion::from_positions(point, times_at({0, 0}), {{}, {}}));
  EXPECT_FALSE(Motion::from_positions(point, times_at({0}), {{std::nan(""), 0, 0}}));
  EXPECT_FALSE(Motion::from_positions(point, times_at({0}), {{}}, {1.5}));
  EXPECT_FALSE(Motion::from_positions(point, times_at({0, 1}), {{}}));
}

TEST(Motion, resampling_at_its_own_times_changes_nothing) {
  const Motion motion = turning_motion();
  const Motion again = resample(motion, motion.times());
  for (int frame = 0; frame < motion.frame_count(); ++frame)
    for (int j = 0; j < motion.joint_count(); ++j)
      EXPECT_NEAR(glm::distance(motion.position(frame, j), again.position(frame, j)), 0, 1e-12);
}

TEST(Motion, resampling_goes_by_time_not_by_frame_number) {
  const Motion halfway = resample(turning_motion(), times_at({1.0}));
  EXPECT_NEAR(halfway.position(0, 0).x, 0.75, 1e-12);  // half between 0.5 s and 1.5 s
}

TEST(Motion, resampling_at_a_rate_covers_the_whole_motion) {
  const Motion motion = resample(turning_motion(), 30.0);
  EXPECT_EQ(motion.frame_count(), 46);
  EXPECT_NEAR(motion.frame_rate(), 30, 1e-3);
}

TEST(Motion, mirroring_twice_is_the_identity_and_once_swaps_the_sides) {
  const Motion motion = turning_motion();
  const Motion mirror = mirrored(motion);
  const Motion twice = mirrored(mirror);
  const int left = motion.skeleton().find(HumanoidJoint::LeftWrist);
  const int right = motion.skeleton().find(HumanoidJoint::RightWrist);
  for (int frame = 0; frame < motion.frame_count(); ++frame) {
    const Vec3 there = motion.position(frame, left);
    EXPECT_NEAR(glm::distance(mirror.position(frame, right), Vec3(-there.x, there.y, there.z)), 0, 1e-12);
    for (int j = 0; j < motion.joint_count(); ++j)
      EXPECT_NEAR(glm::distance(motion.position(frame, j), twice.position(frame, j)), 0, 1e-12);
  }
}

}  // namespace
}  // namespace posecoach
