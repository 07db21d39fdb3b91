#include "core/retarget/retarget.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "core/body/landmark_body.h"
#include "core/body/mirror.h"
#include "core/body/standard_body.h"
#include "core/retarget/t_pose.h"
#include "tests/core/retarget/motions.h"

namespace posecoach {
namespace {

double largest_difference(const Motion& a, const Motion& b) {
  double worst = 0;
  for (int f = 0; f < a.frame_count(); ++f)
    for (int j = 0; j < a.joint_count(); ++j)
      worst = std::max(worst, glm::distance(a.position(f, j), b.position(f, j)));
  return worst;
}

Motion retargeted(const Motion& coach, const Skeleton& body, const RetargetOptions& options = {}) {
  Result<RetargetResult> result = retarget(coach, body, options);
  EXPECT_TRUE(result) << result.error().message;
  return result->motion;
}

class EveryMethod : public testing::TestWithParam<RetargetMethod> {};

TEST_P(EveryMethod, a_motion_on_its_own_body_stays_as_it_is) {
  const Motion with_rotations = random_motion(make_standard_body(), 40, 1);
  const Motion positions_only = without_rotations(with_rotations);
  for (const RotationSource source : {RotationSource::FileFirst, RotationSource::Positions}) {
    const Motion back =
        retargeted(with_rotations, with_rotations.skeleton(), {GetParam(), Contacts::Off, source});
    EXPECT_LT(largest_difference(back, with_rotations), 1e-9);
  }
  EXPECT_LT(
      largest_difference(retargeted(positions_only, positions_only.skeleton(), {GetParam(), Contacts::Off}),
                         positions_only),
      1e-9);
}

TEST_P(EveryMethod, a_webcam_body_on_itself_stays_as_it_is) {
  const Motion motion = random_motion(test_landmark_body(1.0), 30, 2);
  EXPECT_LT(
      largest_difference(
          retargeted(without_rotations(motion), motion.skeleton(), {GetParam(), Contacts::Off}), motion),
      1e-9);
}

TEST_P(EveryMethod, turning_and_shifting_the_coachs_world_turns_and_scales_the_students) {
  const Motion coach = random_motion(make_standard_body(), 20, 3);
  const Skeleton body = make_standard_body({.height_m = 1.6, .arms = 1.15, .torso = 0.9, .thighs = 0.95});
  const Quat yaw = glm::angleAxis(1.1, Vec3(0, 1, 0));
  const Vec3 shift(0.4, 0, -0.7);
  const Motion plain = retargeted(coach, body, {GetParam(), Contacts::Off});
  const Motion moved = retargeted(transformed(coach, yaw, shift), body, {GetParam(), Contacts::Off});
  // The shift is scaled like the path.
  const Vec3 scaled_shift = moved.position(0, 0) - yaw * plain.position(0, 0);
  EXPECT_NEAR(scaled_shift.y, 0, 1e-9);
  EXPECT_NEAR(scaled_shift.x / shift.x, scaled_shift.z / shift.z, 1e-9);
  EXPECT_LT(largest_difference(moved, transformed(plain, yaw, scaled_shift)), 1e-9);
}

TEST_P(EveryMethod, mirroring_before_or_after_is_the_same) {
  const Motion coach = without_rotations(random_motion(make_standard_body(), 20, 4));
  const Skeleton body = make_standard_body({.height_m = 1.9, .arms = 0.9, .shoulders = 1.1, .shins = 1.05});
  EXPECT_LT(largest_difference(retargeted(mirrored(coach), mirrored(body), {GetParam(), Contacts::Off}),
                               mirrored(retargeted(coach, body, {GetParam(), Contacts::Off}))),
            1e-9);
}

TEST_P(EveryMethod, one_frame_is_a_motion_too) {
  const Motion coach = random_motion(make_standard_body(), 1, 5);
  const Motion student = retargeted(coach, test_landmark_body(1.1), {GetParam(), Contacts::On});
  EXPECT_EQ(student.frame_count(), 1);
}

INSTANTIATE_TEST_SUITE_P(Methods, EveryMethod,
                         testing::Values(RetargetMethod::Rotation, RetargetMethod::Direction,
                                         RetargetMethod::Scale, RetargetMethod::Network),
                         [](const auto& method) { return std::string(to_string(method.param)); });

TEST(Retarget, the_same_rotations_on_another_body_of_the_same_rest_directions_come_out_exactly) {
  const Skeleton coach_body = make_standard_body(),
                 body = make_standard_body({.height_m = 1.5, .arms = 1.2, .thighs = 0.8});
  const Motion coach = random_motion(coach_body, 30, 6);
  const Motion truth = same_rotations(coach, body);
  const Motion found = retargeted(without_rotations(coach), body);
  for (int f = 0; f < truth.frame_count(); ++f)
    for (int j = 0; j < truth.joint_count(); ++j)
      EXPECT_LT(glm::distance(found.position(f, j) - found.position(f, 0),
                              truth.position(f, j) - truth.position(f, 0)),
                1e-6);
}

TEST(Retarget, bone_lengths_are_the_students_on_rigs_with_other_joints) {
  const Motion coach = random_motion(make_standard_body(), 30, 7);
  for (const RetargetMethod method : {RetargetMethod::Rotation, RetargetMethod::Direction}) {
    for (const Contacts contacts : {Contacts::Off, Contacts::On}) {
      const auto on_webcam = retarget(coach, test_landmark_body(1.15), {method, contacts});
      ASSERT_TRUE(on_webcam);
      EXPECT_LT(on_webcam->bone_length_error_max, 1e-9);
      const auto back =
          retarget(without_rotations(on_webcam->motion), make_standard_body(), {method, contacts});
      ASSERT_TRUE(back);
      EXPECT_LT(back->bone_length_error_max, 1e-9);
    }
  }
}

TEST(Retarget, a_webcam_body_follows_the_limbs_of_a_rig_with_more_joints_and_back) {
  const Motion coach = random_motion(make_standard_body(), 30, 8);
  const Motion webcam = retargeted(coach, test_landmark_body(1.0));
  const Motion back = retargeted(without_rotations(webcam), coach.skeleton());
  using enum HumanoidJoint;
  for (const Motion* student : {&webcam, &back})
    for (const auto& [from, to] : {std::pair(LeftShoulder, LeftElbow), std::pair(RightElbow, RightWrist),
                                   std::pair(LeftHip, LeftKnee), std::pair(RightKnee, RightAnkle)})
      for (int f = 0; f < coach.frame_count(); ++f) {
        const auto bone = [&](const Motion& m) {
          return glm::normalize(m.position(f, m.skeleton().find(to)) -
                                m.position(f, m.skeleton().find(from)));
        };
        EXPECT_LT(glm::distance(bone(*student), bone(coach)), 1e-6);
      }
}

TEST(Retarget, an_a_pose_rig_gives_the_same_student_as_a_t_pose_rig) {
  const Motion coach = random_motion(make_standard_body(), 20, 9);
  const Motion a_pose = with_rest_pose_changed(coach, HumanoidJoint::LeftShoulder, Vec3(0, 0, 1), -0.8);
  const Skeleton body = make_standard_body({.height_m = 1.65, .forearms = 1.1});
  EXPECT_LT(largest_difference(retargeted(coach, body), retargeted(a_pose, body)), 1e-9);
  // And as a body: the student's rest pose does not change what he does.
  const Motion on_a_pose = retargeted(coach, a_pose.skeleton());
  EXPECT_LT(largest_difference(on_a_pose, coach), 1e-9);
}

TEST(Retarget, a_body_without_legs_is_incomplete_and_says_what_is_missing) {
  const Skeleton body = *Skeleton::make({{"root", kNoJoint, {0, 1, 0}, HumanoidJoint::Pelvis}});
  const auto result = retarget(random_motion(make_standard_body(), 3, 10), body);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::Incomplete);
  EXPECT_NE(result.error().message.find("left_knee"), std::string::npos);
}

TEST(Retarget, standing_feet_stay_near_the_floor) {
  const Motion coach = standing_motion(make_standard_body(), 10);
  const Skeleton body = make_standard_body({.height_m = 1.95, .torso = 0.9, .thighs = 1.1});
  const Motion student = retargeted(coach, body);
  const int toe = body.find(HumanoidJoint::LeftToeTip);
  for (int f = 0; f < student.frame_count(); ++f) EXPECT_NEAR(student.position(f, toe).y, 0, 0.01);
}

}  // namespace
}  // namespace posecoach
