#include "core/transfer/pose2d.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "core/transfer/pose2d_sources.h"
#include "tests/core/transfer/test_people.h"
#include "tests/support/temporary_folder.h"

namespace posecoach {
namespace {

Pose2d any_pose() {
  return project(waving_clip(0.3).poses[7], {0.6, 0});
}

TEST(Pose2d, bones_reach_every_joint_from_the_mid_hip_once) {
  std::set<Joint2d> reached = {Joint2d::MidHip};
  for (std::size_t b = 0; b < kBone2dCount; ++b) {
    EXPECT_TRUE(reached.contains(kBones2d[b].parent)) << b;
    EXPECT_TRUE(reached.insert(kBones2d[b].child).second) << b;
    const Bone2d& twin = kBones2d[kBones2d[b].twin];
    EXPECT_EQ(twin.child, mirrored(kBones2d[b].child));
    EXPECT_EQ(kBones2d[kBones2d[b].twin].twin, b);
  }
  EXPECT_EQ(reached.size(), kJoint2dCount);
}

TEST(Pose2d, mirroring_twice_changes_nothing_and_once_exchanges_sides) {
  const Pose2d pose = any_pose(), twice = mirrored(mirrored(pose));
  EXPECT_EQ(pose.positions, twice.positions);
  EXPECT_EQ(mirrored(pose)[Joint2d::LeftWrist].x, -pose[Joint2d::RightWrist].x);
  EXPECT_EQ(to_string(mirrored(Joint2d::LeftAnkle)), "right_ankle");
  EXPECT_EQ(mirrored(Joint2d::Nose), Joint2d::Nose);
}

TEST(Pose2d, joints_come_back_from_their_bones) {
  const Pose2d pose = any_pose();
  std::array<Vec2, kBone2dCount> bones;
  for (std::size_t b = 0; b < kBone2dCount; ++b) bones[b] = *bone_vector(pose, b);
  const Pose2d again = pose_from_bones(bones, pose[Joint2d::MidHip]);
  for (std::size_t i = 0; i < kJoint2dCount; ++i)
    EXPECT_NEAR(glm::length(again.positions[i] - pose.positions[i]), 0, 1e-12);
}

TEST(Pose2d, a_middle_without_one_of_its_sides_is_not_seen) {
  Pose2d pose = any_pose();
  pose.seen[index(Joint2d::LeftShoulder)] = false;
  pose = with_midpoints(pose);
  EXPECT_FALSE(pose.is_seen(Joint2d::Neck));
  EXPECT_TRUE(pose.is_seen(Joint2d::MidHip));
  EXPECT_FALSE(bone_vector(pose, 0).has_value());
}

TEST(Pose2d, a_hidden_elbow_between_seen_ends_is_bridged_and_nothing_else) {
  Pose2d pose = any_pose();
  pose.seen[index(Joint2d::LeftElbow)] = pose.seen[index(Joint2d::RightKnee)] =
      pose.seen[index(Joint2d::RightAnkle)] = false;
  const Pose2d whole = bridged(pose);
  EXPECT_TRUE(whole.is_seen(Joint2d::LeftElbow));
  const Vec2 limb = pose[Joint2d::LeftWrist] - pose[Joint2d::LeftShoulder],
             upper = whole[Joint2d::LeftElbow] - pose[Joint2d::LeftShoulder];
  EXPECT_NEAR(limb.x * upper.y - limb.y * upper.x, 0, 1e-12);
  EXPECT_NEAR(glm::length(upper) / glm::length(limb), 0.172 / 0.329, 1e-9);
  EXPECT_FALSE(whole.is_seen(Joint2d::RightKnee));
  for (std::size_t i = 0; i < kJoint2dCount; ++i)
    if (i != index(Joint2d::LeftElbow)) {
      EXPECT_EQ(whole.positions[i], pose.positions[i]);
    }
}

TEST(Pose2d, the_box_leaves_out_what_was_not_seen) {
  Pose2d pose = any_pose();
  const Box2d before = bounding_box(pose);
  pose[Joint2d::Nose] = {1000, 1000};
  pose.seen[index(Joint2d::Nose)] = false;
  EXPECT_LE(bounding_box(pose).high.x, before.high.x);
  EXPECT_NEAR(glm::length(bounding_box(centred(pose)).centre()), 0, 1e-12);
}

TEST(Pose2dSources, landmarks_below_one_half_are_not_seen) {
  ImageKeypoints landmarks;
  for (ImageKeypoint& landmark : landmarks) landmark.visibility = 0.9;
  landmarks[Landmark::LeftShoulder].position_px = {10, 20};
  landmarks[Landmark::RightShoulder].position_px = {30, 40};
  landmarks[Landmark::LeftWrist].visibility = 0.3;
  const Pose2d pose = pose2d_from_landmarks(landmarks);
  EXPECT_EQ(pose[Joint2d::Neck], Vec2(20, 30));
  EXPECT_FALSE(pose.is_seen(Joint2d::LeftWrist));
  EXPECT_TRUE(pose.is_seen(Joint2d::RightWrist));
}

class ClipFile : public testing::Test {
 protected:
  void write(const std::string& text) { std::ofstream(path_) << text; }
  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "clips_for_transfer.json";
};

TEST_F(ClipFile, gives_its_clips_by_number) {
  write(R"({"joints": ["face", "belly", "left_hip", "right_hip"],
            "clips": [{"label": "golf", "frames": [[[1, 2], [9, 9], [3, 4], [5, 6]]]}]})");
  const auto poses = read_clip_poses(path_, 0);
  ASSERT_TRUE(poses.has_value()) << poses.error().message;
  ASSERT_EQ(poses->size(), 1U);
  EXPECT_EQ(poses->front()[Joint2d::MidHip], Vec2(4, 5));
  EXPECT_TRUE(poses->front().is_seen(Joint2d::Nose));
  EXPECT_FALSE(poses->front().is_seen(Joint2d::LeftKnee));
  EXPECT_EQ(read_clip_poses(path_, 1).error().code, ErrorCode::InvalidArgument);
}

TEST_F(ClipFile, that_is_something_else_is_refused_by_name) {
  for (const char* text : {"", "[]", "{\"joints\": [\"face\"], \"clips\": [{\"frames\": [[]]}]}"}) {
    write(text);
    const auto poses = read_clip_poses(path_, 0);
    ASSERT_FALSE(poses.has_value()) << text;
    EXPECT_EQ(poses.error().code, ErrorCode::Malformed);
    EXPECT_NE(poses.error().message.find("clips_for_transfer.json"), std::string::npos);
  }
}

}  // namespace
}  // namespace posecoach
