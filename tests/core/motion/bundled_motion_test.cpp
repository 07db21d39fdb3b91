#include "core/motion/bundled_motion.h"

#include <gtest/gtest.h>

#include "tests/core/motion/authored/golfer_measures.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

class BundledMotion : public testing::TestWithParam<const char*> {
 protected:
  const AuthoredMotion authored = bundled_authored_motion(GetParam()).value();
  const Motion& motion = authored.motion;
};

TEST_P(BundledMotion, has_rotations_and_exact_bones) {
  ASSERT_TRUE(motion.has_rotations());
  for (int frame = 0; frame < motion.frame_count(); ++frame)
    for (int j = 1; j < motion.joint_count(); ++j)
      ASSERT_NEAR(
          glm::distance(motion.position(frame, j), motion.position(frame, motion.skeleton().joint(j).parent)),
          motion.skeleton().bone_length(j), 1e-9);
}

TEST_P(BundledMotion, keeps_both_hands_on_the_grip_in_one_relation_to_the_club) {
  const Vec3 first = joint_at(motion, 0, LeftWrist) - joint_at(motion, 0, RightWrist);
  ASSERT_EQ(authored.club.size(), static_cast<std::size_t>(motion.frame_count()));
  const auto lead_to_grip = glm::distance(joint_at(motion, 0, LeftWrist), authored.club[0].grip);
  for (int frame = 0; frame < motion.frame_count(); ++frame) {
    const ClubPose& club = authored.club[static_cast<std::size_t>(frame)];
    const Vec3 apart = joint_at(motion, frame, LeftWrist) - joint_at(motion, frame, RightWrist);
    ASSERT_LT(glm::length(apart), 0.12);
    ASSERT_NEAR(glm::length(apart), glm::length(first), 1e-9);
    ASSERT_NEAR(glm::distance(joint_at(motion, frame, LeftWrist), club.grip), lead_to_grip, 1e-9);
    ASSERT_NEAR(glm::distance(club.grip, club.head),
                glm::distance(authored.club[0].grip, authored.club[0].head), 1e-9);
  }
  EXPECT_EQ(authored.deficit_m, 0);
}

TEST_P(BundledMotion, keeps_the_feet_where_they_are) {
  for (int frame = 0; frame < motion.frame_count(); ++frame) {
    for (const HumanoidJoint joint : {LeftAnkle, LeftToe, LeftToeTip, RightToe})
      ASSERT_LT(glm::distance(joint_at(motion, frame, joint), joint_at(motion, 0, joint)), 1e-9);
    ASSERT_GE(joint_at(motion, frame, RightAnkle).y, joint_at(motion, 0, RightAnkle).y - 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Both, BundledMotion, testing::Values("swing", "putt"));

TEST(BundledMotionNames, unknown_name_is_an_error_that_lists_the_known_ones) {
  const auto none = bundled_motion("chip");
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ErrorCode::NotFound);
  EXPECT_NE(none.error().message.find("swing"), std::string::npos);
  for (const std::string& name : bundled_motion_names()) EXPECT_TRUE(bundled_motion(name));
}

}  // namespace
}  // namespace posecoach
