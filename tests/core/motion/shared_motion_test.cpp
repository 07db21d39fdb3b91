// Real files that lie beside the repository; skipped where they are absent.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/motion/motion_file.h"
#include "core/motion/rig.h"
#include "tests/support/shared_data.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;
namespace fs = std::filesystem;

std::vector<fs::path> files_in(const fs::path& folder, std::string_view extension) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == extension) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

const Vec3& at(const Motion& motion, int frame, HumanoidJoint role) {
  return motion.position(frame, motion.skeleton().find(role));
}

double lowest_foot(const Motion& motion, int frame) {
  double low = std::min(at(motion, frame, LeftAnkle).y, at(motion, frame, RightAnkle).y);
  for (const HumanoidJoint toe : {LeftToe, RightToe})
    if (motion.skeleton().has(toe)) low = std::min(low, at(motion, frame, toe).y);
  return low;
}

// Hip to knee to ankle, and pelvis to the highest joint of the spine.
void expect_a_standing_person(const Motion& motion, const std::string& name) {
  const Skeleton& body = motion.skeleton();
  EXPECT_TRUE(check_humanoid(body)) << name << ": " << check_humanoid(body).error().message;
  const HumanoidJoint top = body.has(Neck) ? Neck : Chest;
  std::vector<double> heights, feet, upright;
  for (int f = 0; f < motion.frame_count(); f += 3) {
    feet.push_back(lowest_foot(motion, f));
    heights.push_back(at(motion, f, top).y - lowest_foot(motion, f));
    upright.push_back(at(motion, f, top).y - at(motion, f, Pelvis).y);
  }
  EXPECT_GT(median(heights), 0.5) << name;  // cartoon figures are small
  EXPECT_LT(median(heights), 2.0) << name;
  EXPECT_GT(median(upright), 0) << name;
  // Some takes begin with a T-pose that floats or sinks; nearly all other frames stand on the floor.
  std::sort(feet.begin(), feet.end());
  EXPECT_GT(feet[feet.size() / 20], -0.12) << name;
}

void expect_rigid_bones(const Motion& motion, const std::string& name) {
  for (int f = 0; f < motion.frame_count(); f += 50)
    for (int j = 1; j < motion.joint_count(); ++j) {
      const double length =
          glm::distance(motion.position(f, j), motion.position(f, motion.skeleton().joint(j).parent));
      ASSERT_NEAR(length, motion.skeleton().bone_length(j), 1e-9)
          << name << " " << motion.skeleton().joint(j).name;
    }
}

// Left is to the left: seen from above, facing forward.
void expect_left_on_the_left(const Motion& motion, const std::string& name) {
  const auto rest = motion.skeleton().rest_positions();
  const auto rest_at = [&](HumanoidJoint role) {
    return rest[static_cast<std::size_t>(motion.skeleton().find(role))];
  };
  EXPECT_GT(rest_at(LeftWrist).x, rest_at(RightWrist).x) << name;
  EXPECT_GT(rest_at(LeftHip).x, rest_at(RightHip).x) << name;
  if (motion.skeleton().has(LeftToe)) {
    EXPECT_GT(rest_at(LeftToe).z, rest_at(LeftAnkle).z) << name;
  }
}

void expect_written_bvh_to_keep(const MotionFile& file, const std::string& name) {
  const fs::path path = fs::path(testing::TempDir()) / "posecoach_shared_round_trip.bvh";
  const Motion part = file.motion.slice(0, std::min(200, file.motion.frame_count()));
  ASSERT_TRUE(write_motion_file(path, part, file.provenance));
  const auto again = read_motion_file(path);
  ASSERT_TRUE(again) << name << ": " << again.error().message;
  ASSERT_EQ(again->motion.joint_count(), part.joint_count()) << name;
  EXPECT_EQ(again->provenance.bvh.size(), file.provenance.bvh.size()) << name;
  for (int f = 0; f < part.frame_count(); ++f)
    for (int j = 0; j < part.joint_count(); ++j)
      ASSERT_LT(glm::distance(again->motion.position(f, j), part.position(f, j)), 1e-6) << name;
}

TEST(SharedMotion, every_bvh_is_a_person_with_rigid_bones_that_is_written_back_alike) {
  for (const char* folder : {"data/motion/cmu_bvh", "data/paired", "data/golf"}) {
    const auto found = shared_data(folder);
    if (!found) GTEST_SKIP() << folder << " is not beside the repository";
    for (const fs::path& path : files_in(*found, ".bvh")) {
      const auto file = read_motion_file(path);
      ASSERT_TRUE(file) << file.error().message;
      expect_a_standing_person(file->motion, path.string());
      expect_rigid_bones(file->motion, path.string());
      expect_left_on_the_left(file->motion, path.string());
      expect_written_bvh_to_keep(*file, path.string());
    }
  }
}

TEST(SharedMotion, every_amc_is_a_person_with_rigid_bones) {
  const auto found = shared_data("data/motion/cmu_amc");
  if (!found) GTEST_SKIP() << "data/motion/cmu_amc is not beside the repository";
  const auto paths = files_in(*found, ".amc");
  EXPECT_EQ(paths.size(), 28u);
  for (const fs::path& path : paths) {
    const auto file = read_motion_file(path);
    ASSERT_TRUE(file) << file.error().message;
    expect_a_standing_person(file->motion, path.string());
    expect_rigid_bones(file->motion, path.string());
    expect_left_on_the_left(file->motion, path.string());
    EXPECT_NEAR(file->motion.skeleton().leg_length(), 0.83, 0.05) << path;
  }
}

TEST(SharedMotion, a_walk_keeps_one_foot_near_the_floor) {
  const auto found = shared_data("data/motion/cmu_amc/02_01.amc");
  if (!found) GTEST_SKIP() << "data/motion/cmu_amc is not beside the repository";
  const Motion motion = read_motion_file(*found)->motion;
  for (int f = 0; f < motion.frame_count(); ++f) {
    EXPECT_GT(lowest_foot(motion, f), -0.02);
    EXPECT_LT(lowest_foot(motion, f), 0.10);
  }
}

TEST(SharedMotion, the_marked_golfer_stands_upright_with_both_hands_on_the_club) {
  const auto found = shared_data("data/golf/swing_360hz_driver.c3d");
  if (!found) GTEST_SKIP() << "data/golf is not beside the repository";
  const auto file = read_motion_file(*found);
  ASSERT_TRUE(file) << file.error().message;
  const Motion& motion = file->motion;
  EXPECT_EQ(motion.frame_count(), 654);
  EXPECT_NEAR(motion.frame_rate(), 360, 1e-3);
  expect_a_standing_person(motion, "golfer");
  const int shoulder = motion.skeleton().find(RightShoulder);
  for (int f = 0; f < motion.frame_count(); ++f) {
    EXPECT_LT(glm::distance(at(motion, f, LeftWrist), at(motion, f, RightWrist)), 0.2);
    // Half of the right shoulder's markers are hidden for most of the swing: where it is estimated, too, it
    // keeps its distance to the other shoulder and the elbow.
    EXPECT_NEAR(glm::distance(motion.position(f, shoulder), at(motion, f, LeftShoulder)), 0.28, 0.06) << f;
    EXPECT_NEAR(glm::distance(motion.position(f, shoulder), at(motion, f, RightElbow)), 0.38, 0.06) << f;
    if (f > 0) {
      EXPECT_LT(glm::distance(motion.position(f, shoulder), motion.position(f - 1, shoulder)), 0.02);
    }
  }
  EXPECT_EQ(motion.confidence(0, shoulder), 0.5);
  EXPECT_EQ(motion.confidence(600, shoulder), 1.0);
}

TEST(SharedMotion, two_characters_of_the_same_motion_turn_their_arms_alike) {
  const auto ortiz = shared_data("data/paired/Ortiz/Angry.bvh"),
             mousey = shared_data("data/paired/Mousey/Angry.bvh");
  if (!ortiz || !mousey) GTEST_SKIP() << "data/paired is not beside the repository";
  const Motion a = read_motion_file(*ortiz)->motion, b = read_motion_file(*mousey)->motion;
  ASSERT_EQ(a.frame_count(), b.frame_count());
  EXPECT_EQ(a.time(a.frame_count() - 1), b.time(b.frame_count() - 1));
  // The same motion: the same local rotations in the arms.
  for (const HumanoidJoint role : {LeftShoulder, LeftElbow, RightElbow}) {
    const auto i = static_cast<std::size_t>(a.skeleton().find(role)),
               j = static_cast<std::size_t>(b.skeleton().find(role));
    for (int f = 0; f < a.frame_count(); f += 100)
      EXPECT_GT(std::abs(glm::dot(a.rotations(f)[i], b.rotations(f)[j])), 0.95)
          << to_string(role) << " " << f;
  }
}

}  // namespace
}  // namespace posecoach
