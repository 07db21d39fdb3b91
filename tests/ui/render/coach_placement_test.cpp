#include "ui/render/coach_placement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "tests/support/compared_motions.h"

namespace posecoach {
namespace {

using Path = std::vector<std::pair<int, int>>;

Path random_path(int student_frames, std::mt19937& random) {
  Path path = {{0, 0}};
  while (path.back().first < student_frames - 1) {
    auto [student, coach] = path.back();
    const auto move = random() % 3;
    if (move != 1) ++student;
    if (move != 0) ++coach;
    path.emplace_back(student, coach);
  }
  return path;
}

TEST(FollowPath, stays_with_a_pair_of_the_path_and_never_goes_back) {
  std::mt19937 random(11);
  for (int round = 0; round < 50; ++round) {
    const Path path = random_path(80, random);
    const std::vector<double> frames = follow_path(path, 80);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      double nearest = 1e9;
      for (const auto& [student, coach] : path)
        if (student == static_cast<int>(i)) nearest = std::min(nearest, std::abs(coach - frames[i]));
      EXPECT_LE(nearest, 0.5 + 1e-9) << i;
      if (i > 0) {
        EXPECT_GE(frames[i], frames[i - 1] - 1e-9) << i;
      }
    }
  }
}

TEST(FollowPath, coach_waits_before_the_path_and_after_it) {
  const std::vector<double> frames = follow_path({{10, 3}, {11, 4}, {12, 5}}, 20);
  for (int i = 0; i < 9; ++i) EXPECT_NEAR(frames[static_cast<std::size_t>(i)], 3, 0.5);
  EXPECT_EQ(frames.front(), 3);
  EXPECT_EQ(frames.back(), 5);
}

TEST(FollowPath, a_staircase_becomes_even) {
  Path path;
  for (int i = 0; i < 60; ++i) path.emplace_back(i, i / 3);  // a coach with a third of the frames
  const std::vector<double> frames = follow_path(path, 60);
  for (std::size_t i = 15; i < 45; ++i) EXPECT_NEAR(frames[i + 1] - frames[i], 1.0 / 3, 0.15) << i;
}

Vec3 middle_of_feet(const Skeleton& skeleton, std::span<const Vec3> positions) {
  Vec3 sum(0);
  for (const HumanoidJoint role :
       {HumanoidJoint::LeftAnkle, HumanoidJoint::RightAnkle, HumanoidJoint::LeftToe, HumanoidJoint::RightToe})
    sum += 0.25 * positions[static_cast<std::size_t>(skeleton.find(role))];
  return sum;
}

Motion moved(const Motion& motion, const std::function<Vec3(int)>& offset) {
  std::vector<Vec3> positions;
  for (int frame = 0; frame < motion.frame_count(); ++frame)
    for (const Vec3& p : motion.positions(frame)) positions.push_back(p + offset(frame));
  std::vector<MediaTime> times(motion.times().begin(), motion.times().end());
  return Motion::from_positions(motion.skeleton(), times, positions).value();
}

TEST(StandOnFeet, coach_stands_on_the_students_feet) {
  const ComparedMotions motions = make_compared_motions();
  const Motion student = moved(motions.student, [](int) { return Vec3(3, 0.2, -2); });
  const CoachPlacement placement = stand_on_feet(student, motions.coach, motions.analysis.path);
  for (int frame = 0; frame < student.frame_count(); frame += 7) {
    const Vec3 his = middle_of_feet(student.skeleton(), student.positions(frame));
    const Vec3 coachs = middle_of_feet(student.skeleton(), placement.positions(motions.coach, frame));
    EXPECT_LT(glm::length(his - coachs), 1e-9) << frame;
  }
}

TEST(StandOnFeet, a_jittering_student_does_not_shake_the_coach) {
  const ComparedMotions motions = make_compared_motions();
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 0.03);
  const Motion student = moved(motions.student, [&](int) { return Vec3(noise(random), 0, noise(random)); });
  const CoachPlacement placement = stand_on_feet(student, motions.coach, motions.analysis.path);
  for (std::size_t i = 1; i < placement.offset.size(); ++i)
    EXPECT_LT(glm::length(placement.offset[i] - placement.offset[i - 1]), 0.002) << i;
  EXPECT_LT(glm::length(placement.offset[30]), 0.02);
}

TEST(StandOnFeet, coach_follows_a_student_who_walks_away) {
  const ComparedMotions motions = make_compared_motions(120);
  // A metre aside within the second half, which lasts a second.
  const Motion student =
      moved(motions.student, [](int frame) { return Vec3(frame < 60 ? 0.0 : (frame - 60) / 60.0, 0, 0); });
  const CoachPlacement placement = stand_on_feet(
      student, motions.coach, Path(motions.analysis.path.begin(), motions.analysis.path.begin() + 60));
  EXPECT_LT(glm::length(placement.offset[10]), 0.05);
  EXPECT_NEAR(placement.offset[110].x, 50 / 60.0, 0.25);
  for (std::size_t i = 1; i < placement.offset.size(); ++i)
    EXPECT_LT(glm::length(placement.offset[i] - placement.offset[i - 1]), 0.08) << i;
}

}  // namespace
}  // namespace posecoach
