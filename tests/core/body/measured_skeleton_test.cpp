#include "core/body/measured_skeleton.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <vector>

#include "core/body/forward_kinematics.h"
#include "core/body/standard_body.h"

namespace posecoach {
namespace {

std::vector<MeasuredJoint> joints_of(const Skeleton& body) {
  std::vector<MeasuredJoint> joints;
  for (const Joint& joint : body.joints()) joints.push_back({joint.name, joint.parent, joint.role.value()});
  return joints;
}

std::vector<Vec3> bent_frames(const Skeleton& body, int frames) {
  std::vector<Vec3> positions;
  for (int frame = 0; frame < frames; ++frame) {
    Pose pose = rest_pose(body);
    for (std::size_t j = 0; j < pose.rotations.size(); ++j)
      pose.rotations[j] =
          glm::angleAxis(0.2 * static_cast<double>((static_cast<std::size_t>(frame) * 5 + j * 3) % 11) - 1.0,
                         Vec3(0.6, 0, 0.8));
    const std::vector<Vec3> at = forward_kinematics(body, pose);
    positions.insert(positions.end(), at.begin(), at.end());
  }
  return positions;
}

TEST(MeasuredSkeleton, a_standard_body_in_any_posture_is_measured_as_itself) {
  const Skeleton body = make_standard_body({.height_m = 1.62, .arms = 1.1, .shins = 0.9});
  const Skeleton measured = measure_skeleton(joints_of(body), bent_frames(body, 7)).value();
  for (int j = 1; j < body.size(); ++j) {
    EXPECT_NEAR(measured.bone_length(j), body.bone_length(j), 1e-12) << body.joint(j).name;
    EXPECT_EQ(measured.joint(j).role, body.joint(j).role);
  }
  EXPECT_NEAR(measured.leg_length(), body.leg_length(), 1e-12);
}

TEST(MeasuredSkeleton, frames_in_which_a_joint_is_not_seen_do_not_count) {
  const Skeleton body = make_standard_body();
  std::vector<Vec3> positions = bent_frames(body, 5);
  std::vector<double> confidence(positions.size(), 1.0);
  const auto row = static_cast<std::size_t>(body.size());
  const auto wrist = static_cast<std::size_t>(body.find(HumanoidJoint::LeftWrist));
  for (std::size_t frame = 0; frame < 3; ++frame) {
    positions[frame * row + wrist] = {9, 9, 9};
    confidence[frame * row + wrist] = 0;
  }
  const Skeleton measured = measure_skeleton(joints_of(body), positions, confidence).value();
  EXPECT_NEAR(measured.bone_length(static_cast<int>(wrist)), body.bone_length(static_cast<int>(wrist)),
              1e-12);
}

TEST(MeasuredSkeleton, a_bone_that_is_never_seen_is_named) {
  const Skeleton body = make_standard_body();
  const std::vector<Vec3> positions = bent_frames(body, 2);
  std::vector<double> confidence(positions.size(), 1.0);
  const auto row = static_cast<std::size_t>(body.size());
  const auto knee = static_cast<std::size_t>(body.find(HumanoidJoint::RightKnee));
  confidence[knee] = confidence[row + knee] = 0;
  const auto measured = measure_skeleton(joints_of(body), positions, confidence);
  ASSERT_FALSE(measured);
  EXPECT_EQ(measured.error().code, ErrorCode::Incomplete);
  EXPECT_NE(measured.error().message.find("right_knee"), std::string::npos);
}

TEST(MeasuredSkeleton, left_and_right_get_the_mean_of_both) {
  const std::vector<MeasuredJoint> joints = {{"pelvis", kNoJoint, HumanoidJoint::Pelvis},
                                             {"left_hip", 0, HumanoidJoint::LeftHip},
                                             {"right_hip", 0, HumanoidJoint::RightHip}};
  const Skeleton measured =
      measure_skeleton(joints, std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 0, 3}}).value();
  EXPECT_NEAR(measured.bone_length(1), 2, 1e-12);
  EXPECT_NEAR(measured.bone_length(2), 2, 1e-12);
  EXPECT_GT(measured.joint(1).offset.x, 0);
  EXPECT_LT(measured.joint(2).offset.x, 0);
}

}  // namespace
}  // namespace posecoach
