#include "core/motion/bvh_motion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

#include "bvh_samples.h"
#include "core/body/standard_body.h"

namespace posecoach {
namespace {

using testing::HasSubstr;
using enum HumanoidJoint;

double distance(const Vec3& a, const Vec3& b) {
  return glm::distance(a, b);
}

double largest_difference(const Motion& a, const Motion& b) {
  double worst = 0;
  for (int f = 0; f < a.frame_count(); ++f)
    for (int j = 0; j < a.joint_count(); ++j)
      worst = std::max(worst, distance(a.position(f, j), b.position(f, j)));
  return worst;
}

const Vec3& at(const Motion& motion, int frame, HumanoidJoint role) {
  return motion.position(frame, motion.skeleton().find(role));
}

// Every joint turned at random in every frame.
Motion restless(const Skeleton& skeleton, int frames) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  std::vector<MediaTime> times;
  std::vector<Vec3> roots;
  std::vector<Quat> rotations;
  for (int f = 0; f < frames; ++f) {
    times.push_back(media_time_from_seconds(f / 50.0));
    roots.emplace_back(0.1 * f, 1, normal(random));
    for (int j = 0; j < skeleton.size(); ++j)
      rotations.push_back(
          glm::normalize(Quat(normal(random), normal(random), normal(random), normal(random))));
  }
  return Motion::from_rotations(skeleton, times, roots, rotations).value();
}

TEST(BvhReader, channels_act_in_their_order_and_the_root_s_position_replaces_its_offset) {
  const MotionFile file = read_bvh("a.bvh", samples::kThreeJoints).value();
  const double unit = file.provenance.frame.metres_per_unit;
  EXPECT_EQ(unit, 0.01);
  EXPECT_EQ(file.motion.joint_count(), 3);
  EXPECT_EQ(file.motion.skeleton().joint(2).name, "middle_end");
  EXPECT_LT(distance(file.motion.position(0, 2), Vec3(1, 172, 3) * unit), 1e-12);
  // Z by 90 degrees lays the first bone towards -X; X by 90 degrees then turns the second towards +Z.
  EXPECT_LT(distance(file.motion.position(1, 1), Vec3(-99, 2, 3) * unit), 1e-12);
  EXPECT_LT(distance(file.motion.position(1, 2), Vec3(-99, 2, 73) * unit), 1e-12);
  EXPECT_NEAR(to_seconds(file.motion.time(1)), 0.04, 1e-9);
}

TEST(BvhReader, an_end_site_without_length_is_no_joint_but_is_written_again) {
  std::string text(samples::kThreeJoints);
  text.replace(text.find("OFFSET 0 70 0"), 13, "OFFSET 0 0 0");
  const MotionFile file = read_bvh("a.bvh", text).value();
  EXPECT_EQ(file.motion.joint_count(), 2);
  EXPECT_THAT(bvh_from_motion(file.motion, file.provenance).value(), HasSubstr("End Site"));
}

class BvhUnit : public testing::TestWithParam<double> {};

TEST_P(BvhUnit, is_told_from_the_body_s_height) {
  const MotionFile file = read_bvh("a.bvh", samples::body_bvh(samples::kBiovision, GetParam())).value();
  EXPECT_NEAR(file.provenance.frame.metres_per_unit, 1 / GetParam(), 1e-4 / GetParam());
  EXPECT_NEAR(at(file.motion, 0, Pelvis).y, 0.95, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(MetreCentimetreMillimetreInchCmu, BvhUnit,
                         testing::Values(1.0, 100.0, 1000.0, 1 / 0.0254, 1 / 0.056444));

TEST(BvhReader, a_body_that_stands_along_z_is_stood_up) {
  const MotionFile y_up = read_bvh("y.bvh", samples::body_bvh(samples::kUnreal, 100)).value();
  const MotionFile z_up =
      read_bvh("z.bvh", samples::body_bvh(samples::kUnreal, 100, samples::UpAxis::Z)).value();
  EXPECT_LT(largest_difference(y_up.motion, z_up.motion), 1e-9);
  for (int j = 0; j < y_up.motion.joint_count(); ++j)
    EXPECT_LT(distance(y_up.motion.skeleton().joint(j).offset, z_up.motion.skeleton().joint(j).offset), 1e-9);
}

TEST(BvhReader, a_rest_pose_with_hanging_arms_becomes_a_t_pose_and_the_motion_stays) {
  std::string text = samples::body_bvh(samples::kMixamo, 100);
  for (const auto& [old_part, new_part] :
       {std::pair{"OFFSET 30.000000 0.000000 0.000000", "OFFSET 18.000000 -24.000000 0.000000"},
        std::pair{"OFFSET -30.000000 0.000000 0.000000", "OFFSET -18.000000 -24.000000 0.000000"},
        std::pair{"OFFSET 26.000000 0.000000 0.000000", "OFFSET 15.600000 -20.800000 0.000000"},
        std::pair{"OFFSET -26.000000 0.000000 0.000000", "OFFSET -15.600000 -20.800000 0.000000"}})
    text.replace(text.find(old_part), std::string_view(old_part).size(), new_part);
  const MotionFile file = read_bvh("a_pose.bvh", text).value();
  const auto rest = file.motion.skeleton().rest_positions();
  const auto rest_at = [&](HumanoidJoint role) {
    return rest[static_cast<std::size_t>(file.motion.skeleton().find(role))];
  };
  EXPECT_LT(distance(rest_at(LeftWrist) - rest_at(LeftShoulder), {0.56, 0, 0}), 1e-9);
  EXPECT_LT(distance(rest_at(RightWrist) - rest_at(RightShoulder), {-0.56, 0, 0}), 1e-9);
  EXPECT_LT(distance(at(file.motion, 0, LeftWrist) - at(file.motion, 0, LeftShoulder), {0.336, -0.448, 0}),
            1e-9);
  const MotionFile again = read_bvh("b.bvh", bvh_from_motion(file.motion, file.provenance).value()).value();
  EXPECT_LT(largest_difference(file.motion, again.motion), 1e-8);
  EXPECT_EQ(again.provenance.bvh[4].joint.offset, file.provenance.bvh[4].joint.offset);
}

TEST(BvhReader, position_channels_below_the_root_replace_the_offset) {
  std::string text(samples::kThreeJoints);
  text.replace(text.find("CHANNELS 3"), 10, "CHANNELS 6 Xposition Yposition Zposition");
  text.replace(text.find("1 2 3 0 0 0 0 0 0"), 17, "1 2 3 0 0 0  0 110 0  0 0 0");
  text.replace(text.find("1 2 3 90 0 0 90 0 0"), 19, "1 2 3 90 0 0  0 110 0  90 0 0");
  const MotionFile constant = read_bvh("a.bvh", text).value();
  EXPECT_TRUE(constant.motion.has_rotations());
  EXPECT_NEAR(constant.motion.skeleton().bone_length(1), 1.1, 1e-12);
  const MotionFile again =
      read_bvh("b.bvh", bvh_from_motion(constant.motion, constant.provenance).value()).value();
  EXPECT_LT(largest_difference(constant.motion, again.motion), 1e-9);

  text.replace(text.rfind("0 110 0"), 7, "0 120 0");
  const MotionFile stretching = read_bvh("a.bvh", text).value();
  EXPECT_FALSE(stretching.motion.has_rotations());
  EXPECT_NEAR(distance(stretching.motion.position(1, 0), stretching.motion.position(1, 1)), 1.2, 1e-12);
}

TEST(BvhReader, position_channels_of_zeros_below_the_root_leave_the_offset) {
  std::string text(samples::kThreeJoints);
  text.replace(text.find("CHANNELS 3"), 10, "CHANNELS 6 Xposition Yposition Zposition");
  text.replace(text.find("1 2 3 0 0 0 0 0 0"), 17, "1 2 3 0 0 0  0 0 0  0 0 0");
  text.replace(text.find("1 2 3 90 0 0 90 0 0"), 19, "1 2 3 90 0 0  0 0 0  90 0 0");
  const MotionFile file = read_bvh("a.bvh", text).value();
  EXPECT_NEAR(file.motion.skeleton().bone_length(1), 1.0, 1e-12);
  const MotionFile again = read_bvh("b.bvh", bvh_from_motion(file.motion, file.provenance).value()).value();
  EXPECT_LT(largest_difference(file.motion, again.motion), 1e-9);
}

TEST(BvhReader, hips_that_travel_below_a_reference_are_the_body_s_root) {
  std::string text = samples::body_bvh(samples::kXsens, 100);
  text.replace(text.find("ROOT Hips"), 9,
               "ROOT reference { OFFSET 0 0 0 CHANNELS 6 Xposition Yposition Zposition Zrotation Yrotation "
               "Xrotation JOINT Hips");
  text.replace(text.find("MOTION"), 6, "}\nMOTION");
  text.replace(text.find("\n", text.find("Frame Time")), 1, "\n100 0 0 0 0 0");
  text.insert(text.rfind("\n", text.size() - 2) + 1, "100 0 0 0 90 0 ");
  const MotionFile file = read_bvh("a.bvh", text).value();
  EXPECT_EQ(file.motion.skeleton().joint(0).name, "Hips");
  EXPECT_LT(distance(file.motion.position(0, 0), {1.2, 0.95, 0.1}), 1e-9);
  EXPECT_LT(distance(file.motion.position(1, 0), {1.1, 0.95, -0.2}), 1e-9);  // turned about the reference
  const std::string written = bvh_from_motion(file.motion, file.provenance).value();
  EXPECT_THAT(written, HasSubstr("ROOT reference"));
  EXPECT_LT(largest_difference(file.motion, read_bvh("b.bvh", written)->motion), 1e-8);
}

TEST(BvhReader, a_skeleton_without_frames_is_a_body_but_no_motion) {
  std::string text = samples::body_bvh(samples::kDaz, 100);
  text.resize(text.find("MOTION"));
  EXPECT_EQ(read_bvh("a.bvh", text).error().code, ErrorCode::Incomplete);
  EXPECT_TRUE(read_bvh_skeleton("a.bvh", text)->skeleton.has(LeftElbow));
}

TEST(BvhReader, joints_of_the_same_name_are_told_apart) {
  std::string text(samples::kThreeJoints);
  text.replace(text.find("middle"), 6, "base");
  const MotionFile file = read_bvh("a.bvh", text).value();
  EXPECT_EQ(file.motion.skeleton().joint(1).name, "base_2");
  EXPECT_THAT(bvh_from_motion(file.motion, file.provenance).value(), HasSubstr("JOINT base\n"));
}

TEST(BvhWriter, any_motion_reads_back_within_a_micrometre) {
  const Motion motion = restless(make_standard_body(), 40);
  const MotionFile again = read_bvh("b.bvh", bvh_from_motion(motion, {}).value()).value();
  ASSERT_EQ(again.motion.joint_count(), motion.joint_count());
  for (int j = 0; j < motion.joint_count(); ++j) {
    const int other = again.motion.skeleton().find(motion.skeleton().joint(j).name);
    ASSERT_NE(other, kNoJoint);
    EXPECT_EQ(again.motion.skeleton().joint(other).role, motion.skeleton().joint(j).role);
    for (int f = 0; f < motion.frame_count(); ++f)
      EXPECT_LT(distance(again.motion.position(f, other), motion.position(f, j)), 1e-6);
  }
  EXPECT_NEAR(again.motion.frame_rate(), 50, 1e-6);
}

TEST(BvhWriter, another_motion_of_the_same_body_keeps_names_units_axes_and_channels) {
  const MotionFile body =
      read_bvh("z.bvh", samples::body_bvh(samples::kDaz, 1 / 0.0254, samples::UpAxis::Z)).value();
  const Motion motion = restless(body.motion.skeleton(), 12);
  const std::string text = bvh_from_motion(motion, body.provenance).value();
  EXPECT_THAT(text, HasSubstr("CHANNELS 6 Xposition Yposition Zposition Zrotation Yrotation Xrotation"));
  const BvhDocument written = parse_bvh("b.bvh", text).value();
  ASSERT_EQ(written.joints.size(), body.provenance.bvh.size());
  for (std::size_t j = 0; j < written.joints.size(); ++j) {
    EXPECT_EQ(written.joints[j].name, body.provenance.bvh[j].joint.name);
    EXPECT_LT(distance(written.joints[j].offset, body.provenance.bvh[j].joint.offset), 1e-7);
  }
  // Such wild turning leaves the reader no way to tell what is up in it, so its frame is the body's.
  BvhDocument standing = written;
  standing.values.insert(standing.values.begin(), written.channel_count(), 0.0);
  standing.frame_count += 1;
  const Motion again = read_bvh("c.bvh", format_bvh(standing))->motion.slice(1, 13);
  EXPECT_LT(largest_difference(again, motion), 1e-6);
}

TEST(BvhWriter, a_motion_of_uneven_times_is_resampled_to_one_frame_time) {
  const Skeleton body = make_standard_body();
  std::vector<MediaTime> times;
  std::vector<Vec3> roots;
  for (const double s : {0.0, 0.1, 0.4, 0.5, 1.0}) {
    times.push_back(media_time_from_seconds(s));
    roots.emplace_back(s, 1, 0);
  }
  const std::vector<Quat> still(5 * static_cast<std::size_t>(body.size()), Quat(1, 0, 0, 0));
  const Motion motion = Motion::from_rotations(body, times, roots, still).value();
  const Motion again = read_bvh("b.bvh", bvh_from_motion(motion, {}).value())->motion;
  ASSERT_EQ(again.frame_count(), 5);
  for (int f = 0; f < 5; ++f) EXPECT_NEAR(again.position(f, 0).x, 0.25 * f, 1e-6);
}

TEST(BvhWriter, refuses_positions_without_rotations_and_another_body_s_file) {
  const Skeleton point = Skeleton::make({{"root", kNoJoint, {}, {}}}).value();
  const Motion still = Motion::from_positions(point, {media_time_from_seconds(0)}, {{}}).value();
  EXPECT_EQ(bvh_from_motion(still, {}).error().code, ErrorCode::Unsupported);
  const MotionFile other = read_bvh("a.bvh", samples::kThreeJoints).value();
  EXPECT_EQ(bvh_from_motion(restless(make_standard_body(), 2), other.provenance).error().code,
            ErrorCode::InvalidArgument);
}

}  // namespace
}  // namespace posecoach
