#include "core/transfer/closed_form.h"

#include <gtest/gtest.h>

#include "core/transfer/bone_lengths.h"
#include "core/transfer/evaluation.h"
#include "core/transfer/touching_hands.h"
#include "tests/core/transfer/test_people.h"

namespace posecoach {
namespace {

std::vector<Pose2d> film_of(const SyntheticBody& body, double yaw) {
  const PoseClip clip = waving_clip(0.5, 90);
  std::vector<Pose2d> film;
  for (const Pose3d& pose : clip.poses) film.push_back(project(on_body(pose, clip.lengths, body), {yaw, 0}));
  return film;
}

std::vector<Pose2d> from_all_sides(const SyntheticBody& body) {
  std::vector<Pose2d> all;
  for (int turn = 0; turn < 12; ++turn)
    for (const Pose2d& pose : film_of(body, turn * kPi / 6)) all.push_back(pose);
  return all;
}

SyntheticBody long_legged() {
  SyntheticBody body = average_body(1.6);
  for (const std::size_t b : {10UL, 11UL, 12UL, 13UL}) body.length_m[b] *= 1.4;
  return body;
}

TEST(BoneLengths, of_many_pictures_are_the_true_ones) {
  const SyntheticBody body = long_legged();
  const auto lengths = measure_bone_lengths(from_all_sides(body));
  ASSERT_TRUE(lengths.has_value());
  for (std::size_t b = 0; b < kBone2dCount; ++b) {
    EXPECT_TRUE(lengths->measured[b]) << b;
    EXPECT_LE(lengths->length[b], body.length_m[b] + 1e-9) << b;
    EXPECT_GT(lengths->length[b], 0.93 * body.length_m[b]) << b;
  }
}

TEST(BoneLengths, never_seen_bones_are_of_average_length) {
  std::vector<Pose2d> pictures = film_of(average_body(1.8), 0);
  for (Pose2d& picture : pictures)
    picture.seen[index(Joint2d::LeftAnkle)] = picture.seen[index(Joint2d::RightAnkle)] = false;
  const auto lengths = measure_bone_lengths(pictures);
  ASSERT_TRUE(lengths.has_value());
  EXPECT_FALSE(lengths->measured[12]);
  EXPECT_NEAR(lengths->length[12], 1.8 * kAverageBoneLengths[12], 0.1);
}

TEST(BoneLengths, without_two_connected_joints_there_are_none) {
  EXPECT_EQ(measure_bone_lengths({}).error().code, ErrorCode::Incomplete);
  Pose2d point;
  point.seen.fill(true);
  EXPECT_EQ(measure_bone_lengths(std::vector<Pose2d>{point}).error().code, ErrorCode::Incomplete);
}

TEST(ClosedForm, ratio_meets_the_truth_where_only_lengths_differ) {
  const SyntheticBody first = average_body(1.75), second = long_legged();
  const auto ratio = make_closed_form_transferer(TransferMethod::Ratio);
  ASSERT_TRUE(ratio->set_people(from_all_sides(first), from_all_sides(second)).has_value());
  const std::vector<Pose2d> poses = film_of(first, 0.7), truth = film_of(second, 0.7);
  for (std::size_t i = 0; i < poses.size(); i += 10)
    EXPECT_LT(transfer_error(ratio->transfer(poses[i]).pose, truth[i]).mse_joints, 0.03);
}

TEST(ClosedForm, ratio_gives_back_a_pose_of_the_same_person) {
  const std::vector<Pose2d> film = film_of(long_legged(), 0.2);
  const auto ratio = make_closed_form_transferer(TransferMethod::Ratio);
  ASSERT_TRUE(ratio->set_people(film, film).has_value());
  const Pose2d& pose = film[33];
  EXPECT_NEAR(transfer_error(ratio->transfer(pose).pose, pose).mse_joints, 0, 1e-9);
}

TEST(ClosedForm, bones_have_the_identitys_lengths_and_the_poses_directions) {
  const std::vector<Pose2d> film = film_of(average_body(1.8), 0.5), identity = from_all_sides(long_legged());
  const auto bones = make_closed_form_transferer(TransferMethod::Bones);
  ASSERT_TRUE(bones->set_people(film, identity).has_value());
  const Pose2d result = bones->transfer(film[5]).pose;
  const auto lengths = measure_bone_lengths(identity);
  for (std::size_t b = 0; b < kBone2dCount; ++b)
    EXPECT_NEAR(glm::length(*bone_vector(result, b)), lengths->length[b], 1e-9);
  EXPECT_NEAR(mean_squared_angle(film[5], result, links(Links::Bones)), 0, 1e-9);
}

TEST(ClosedForm, scale_gets_the_identitys_height_and_flips_no_link) {
  const std::vector<Pose2d> film = film_of(average_body(1.8), 0.5);
  const std::vector<Pose2d> identity = {film_of(long_legged(), 0)[3]};
  const auto scale = make_closed_form_transferer(TransferMethod::Scale);
  ASSERT_TRUE(scale->set_people(film, identity).has_value());
  const Pose2d result = scale->transfer(film[8]).pose;
  EXPECT_NEAR(bounding_box(result).size().y, bounding_box(identity[0]).size().y, 1e-9);
  EXPECT_EQ(violations(film[8], result, links(Links::All), projection_directions(4)).flipped, 0);
}

class EveryClosedForm : public testing::TestWithParam<TransferMethod> {};

TEST_P(EveryClosedForm, says_which_joints_it_guessed) {
  const std::vector<Pose2d> film = film_of(average_body(1.8), 0);
  const auto transferer = make_closed_form_transferer(GetParam());
  ASSERT_TRUE(transferer->set_people(film, film).has_value());
  Pose2d pose = film[0];
  pose.seen[index(Joint2d::RightAnkle)] = false;
  const TransferredPose result = transferer->transfer(pose);
  EXPECT_TRUE(result.pose.is_complete());
  ASSERT_FALSE(result.doubts.empty());
  EXPECT_NE(result.doubts[0].find("right ankle"), std::string::npos);
}

TEST_P(EveryClosedForm, takes_bones_of_no_length) {
  const std::vector<Pose2d> film = film_of(average_body(1.8), 0);
  const auto transferer = make_closed_form_transferer(GetParam());
  ASSERT_TRUE(transferer->set_people(film, film).has_value());
  Pose2d pose = film[0];
  pose[Joint2d::LeftWrist] = pose[Joint2d::LeftElbow];
  Pose2d point = pose;
  for (Vec2& p : point.positions) p = pose[Joint2d::Neck];
  for (const Pose2d& strange : {pose, point})
    for (const Vec2& p : transferer->transfer(strange).pose.positions)
      EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
}

INSTANTIATE_TEST_SUITE_P(All, EveryClosedForm,
                         testing::Values(TransferMethod::Scale, TransferMethod::Bones, TransferMethod::Ratio),
                         [](const auto& method) { return std::string(to_string(method.param)); });

TEST(ClosedForm, says_when_a_person_shows_a_bone_only_end_on) {
  std::vector<Pose2d> film = film_of(average_body(1.8), 0);
  const auto ratio = make_closed_form_transferer(TransferMethod::Ratio);
  std::vector<Pose2d> edge_on = film;
  for (Pose2d& picture : edge_on) {
    picture[Joint2d::LeftShoulder] = picture[Joint2d::Neck] + Vec2{0.02, 0};
    picture[Joint2d::RightShoulder] = picture[Joint2d::Neck] - Vec2{0.02, 0};
  }
  ASSERT_TRUE(ratio->set_people(film, edge_on).has_value());
  const TransferredPose result = ratio->transfer(film[0]);
  ASSERT_EQ(result.doubts.size(), 1U);
  EXPECT_NE(result.doubts[0].find("neck to shoulder"), std::string::npos) << result.doubts[0];
}

TEST(TouchingHands, keep_the_offset_of_the_source_in_the_new_size) {
  Pose2d source = film_of(average_body(1.8), 0)[0];
  source[Joint2d::LeftWrist] = {0.1, 0.2};
  source[Joint2d::RightWrist] = {0.1, 0.26};
  const Pose2d before = film_of(long_legged(), 0)[0];
  Pose2d result = before;
  keep_hands_together(result, source, 0.5, 1);
  const Vec2 offset = result[Joint2d::LeftWrist] - result[Joint2d::RightWrist];
  EXPECT_NEAR(offset.x, 0, 1e-12);
  EXPECT_NEAR(offset.y, -0.03, 1e-12);
  const Vec2 middle = result[Joint2d::LeftWrist] + result[Joint2d::RightWrist];
  EXPECT_NEAR(glm::length(middle - before[Joint2d::LeftWrist] - before[Joint2d::RightWrist]), 0, 1e-12);
  source.seen[index(Joint2d::LeftWrist)] = false;
  Pose2d untouched = before;
  keep_hands_together(untouched, source, 0.5, 1);
  EXPECT_EQ(untouched.positions, before.positions);
}

TEST(SyntheticBody, performs_with_its_own_lengths) {
  std::mt19937_64 random(4);
  const PoseClip clip = waving_clip(1);
  for (int i = 0; i < 20; ++i) {
    const SyntheticBody body = random_body(random, SyntheticVariety::Extreme);
    const auto lengths = bone_lengths(on_body(clip.poses[9], clip.lengths, body));
    for (std::size_t b = 0; b < kBone2dCount; ++b)
      if (kBones2d[b].child != Joint2d::Nose) {
        EXPECT_NEAR(lengths[b], body.length_m[b], 1e-9) << b;
      }
  }
}

TEST(SyntheticBody, of_the_recorded_lengths_repeats_the_recording) {
  const PoseClip clip = waving_clip(1);
  const Pose3d same = on_body(clip.poses[9], clip.lengths, average_body(1.75));
  for (std::size_t i = 0; i < kJoint2dCount; ++i)
    EXPECT_NEAR(glm::length(same.positions[i] - clip.poses[9].positions[i]), 0, 1e-9) << i;
}

TEST(SyntheticSamples, are_the_same_for_the_same_seed) {
  const PoseClipPool pool(waving_clips(3));
  std::mt19937_64 one(5), two(5);
  EXPECT_EQ(random_sample(pool, one, {}).truth.positions, random_sample(pool, two, {}).truth.positions);
}

}  // namespace
}  // namespace posecoach
