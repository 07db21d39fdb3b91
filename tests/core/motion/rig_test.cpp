#include "core/motion/rig.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bvh_samples.h"
#include "core/motion/bvh_motion.h"

namespace posecoach {
namespace {

using testing::HasSubstr;
using enum HumanoidJoint;

Skeleton skeleton_of(const samples::RigNames& names) {
  return read_bvh_skeleton("rig.bvh", samples::body_bvh(names, 100))->skeleton;
}

class RigOfTheWild : public testing::TestWithParam<const samples::RigNames*> {};

TEST_P(RigOfTheWild, maps_onto_the_canonical_joints_by_name) {
  const samples::RigNames& names = *GetParam();
  const Skeleton skeleton = skeleton_of(names);
  EXPECT_TRUE(check_humanoid(skeleton));
  const std::pair<HumanoidJoint, std::string_view> expected[] = {{Pelvis, names.hips},
                                                                 {Spine, names.spine},
                                                                 {Chest, names.chest},
                                                                 {Neck, names.neck},
                                                                 {Head, names.head},
                                                                 {LeftClavicle, names.left_collar},
                                                                 {LeftShoulder, names.left_arm},
                                                                 {LeftElbow, names.left_forearm},
                                                                 {LeftWrist, names.left_hand},
                                                                 {RightShoulder, names.right_arm},
                                                                 {RightElbow, names.right_forearm},
                                                                 {RightWrist, names.right_hand},
                                                                 {LeftHip, names.left_thigh},
                                                                 {LeftKnee, names.left_shin},
                                                                 {LeftAnkle, names.left_foot},
                                                                 {RightHip, names.right_thigh},
                                                                 {RightKnee, names.right_shin},
                                                                 {RightAnkle, names.right_foot}};
  for (const auto& [role, name] : expected) {
    ASSERT_TRUE(skeleton.has(role)) << to_string(role);
    EXPECT_EQ(skeleton.joint(skeleton.find(role)).name, name) << to_string(role);
  }
  EXPECT_EQ(skeleton.joint(skeleton.find(HeadTop)).name, std::string(names.head) + "_end");
  EXPECT_EQ(skeleton.joint(skeleton.find(LeftToe)).name, std::string(names.left_foot) + "_end");
}

INSTANTIATE_TEST_SUITE_P(All, RigOfTheWild,
                         testing::Values(&samples::kMixamo, &samples::kDaz, &samples::kBiovision,
                                         &samples::kBiped, &samples::kUnreal, &samples::kSmpl,
                                         &samples::kXsens, &samples::kAmc, &samples::kOwn));

std::vector<Joint> chain(std::initializer_list<Joint> joints) {
  return joints;
}

std::string role_name(const std::vector<Joint>& joints, HumanoidJoint role) {
  const auto roles = map_roles(joints);
  const auto found = std::find(roles.begin(), roles.end(), role);
  return found == roles.end() ? "" : joints[static_cast<std::size_t>(found - roles.begin())].name;
}

std::vector<Joint> old_mixamo() {
  return chain({{"Hips", kNoJoint, {0, 87, 0}, {}},
                {"Pelvis", 0, {0, 0, 0}, {}},
                {"LeftUpLeg", 1, {12, -9, 0}, {}},
                {"LeftLeg", 2, {0, -33, 0}, {}},
                {"LeftFoot", 3, {0, -32, 0}, {}},
                {"LeftToeBase", 4, {0, -11, 13}, {}},
                {"LeftToeBase_end", 5, {0, 17, 0}, {}},
                {"LeftPantLeg", 3, {0, -16, 0}, {}},
                {"RightUpLeg", 1, {-12, -9, 0}, {}},
                {"RightLeg", 8, {0, -33, 0}, {}},
                {"RightFoot", 9, {0, -32, 0}, {}},
                {"Spine", 0, {0, 8, 4}, {}},
                {"Spine1", 11, {0, 11, 0}, {}},
                {"Spine2", 12, {0, 13, 0}, {}},
                {"LeftShoulder", 13, {5, 7, 0}, {}},
                {"LeftArm", 14, {8, 1, 0}, {}},
                {"RightShoulder", 13, {-5, 7, 0}, {}},
                {"RightArm", 16, {-8, 1, 0}, {}}});
}

TEST(Rig, legs_below_a_pelvis_beside_the_spine_keep_the_hips_as_the_body_s_middle) {
  const auto joints = old_mixamo();
  EXPECT_EQ(role_name(joints, Pelvis), "Hips");
  EXPECT_EQ(role_name(joints, LeftHip), "LeftUpLeg");
  EXPECT_EQ(role_name(joints, LeftKnee), "LeftLeg");
  EXPECT_EQ(role_name(joints, SpineMiddle), "Spine1");
}

TEST(Rig, a_toe_end_that_points_to_the_sky_is_no_toe_tip) {
  EXPECT_EQ(role_name(old_mixamo(), LeftToe), "LeftToeBase");
  EXPECT_EQ(role_name(old_mixamo(), LeftToeTip), "");
}

TEST(Rig, of_five_joints_in_the_spine_the_one_half_way_is_the_middle) {
  const auto joints = chain({{"Hips", kNoJoint, {}, {}},
                             {"Spine", 0, {0, 14, 0}, {}},
                             {"Spine1", 1, {0, 10, 0}, {}},
                             {"Spine2", 2, {0, 11, 0}, {}},
                             {"Spine3", 3, {0, 30, 0}, {}},
                             {"LeftArm", 4, {15, 0, 0}, {}},
                             {"RightArm", 4, {-15, 0, 0}, {}},
                             {"LeftUpLeg", 0, {9, 0, 0}, {}},
                             {"RightUpLeg", 0, {-9, 0, 0}, {}}});
  EXPECT_EQ(role_name(joints, Spine), "Spine");
  EXPECT_EQ(role_name(joints, SpineMiddle), "Spine2");
  EXPECT_EQ(role_name(joints, Chest), "Spine3");
}

TEST(Rig, joints_between_the_hips_and_the_thighs_do_not_confuse) {
  const auto joints = chain({{"Hips", kNoJoint, {}, {}},
                             {"LHipJoint", 0, {}, {}},
                             {"LeftUpLeg", 1, {1.3, -1.8, 0.8}, {}},
                             {"LeftLeg", 2, {2.4, -6.7, 0}, {}},
                             {"RHipJoint", 0, {}, {}},
                             {"RightUpLeg", 4, {-1.3, -1.8, 0.8}, {}},
                             {"LowerBack", 0, {}, {}},
                             {"Spine", 6, {0, 2, 0}, {}},
                             {"Spine1", 7, {0, 2, 0}, {}},
                             {"Neck", 8, {}, {}},
                             {"Neck1", 9, {0, 1.7, 0}, {}},
                             {"Head", 10, {0, 1.7, 0}, {}},
                             {"LeftShoulder", 8, {}, {}},
                             {"LeftArm", 12, {3.3, 1.2, 0}, {}},
                             {"RightShoulder", 8, {}, {}},
                             {"RightArm", 14, {-3.3, 1.2, 0}, {}}});
  EXPECT_EQ(role_name(joints, Pelvis), "Hips");
  EXPECT_EQ(role_name(joints, LeftHip), "LeftUpLeg");
  EXPECT_EQ(role_name(joints, Spine), "LowerBack");
  EXPECT_EQ(role_name(joints, SpineMiddle), "Spine");
  EXPECT_EQ(role_name(joints, Chest), "Spine1");
  EXPECT_EQ(role_name(joints, Neck), "Neck");
  EXPECT_EQ(role_name(joints, LeftClavicle), "LeftShoulder");
}

TEST(Rig, names_without_a_left_and_right_mark_are_told_all_the_same) {
  const std::string_view names[] = {"lfemur", "rightupleg", "lowerback", "root", "left", "Thigh.R", "L_Hip"};
  const auto parsed = parse_rig_names(names);
  EXPECT_EQ(parsed[0].side, Side::Middle);  // told apart later, when the base is a known name
  EXPECT_EQ(parsed[5].side, Side::Right);
  EXPECT_EQ(parsed[5].base, "thigh");
  EXPECT_EQ(parsed[6].side, Side::Left);
  EXPECT_EQ(parsed[6].base, "hip");
}

TEST(Rig, a_body_that_cannot_be_mapped_is_told_what_is_missing_and_what_is_there) {
  const Skeleton dog = Skeleton::make({{"withers", kNoJoint, {}, {}}, {"tail", 0, {0, 0, -1}, {}}}).value();
  const auto checked = check_humanoid(dog);
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().code, ErrorCode::Incomplete);
  EXPECT_THAT(checked.error().message, HasSubstr("pelvis, chest or neck, left_shoulder"));
  EXPECT_THAT(checked.error().message, HasSubstr("the joints are withers, tail"));
}

}  // namespace
}  // namespace posecoach
