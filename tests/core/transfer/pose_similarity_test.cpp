#include "core/transfer/pose_similarity.h"

#include <gtest/gtest.h>

#include "core/transfer/evaluation.h"
#include "core/transfer/paired_data.h"
#include "tests/core/transfer/test_people.h"

namespace posecoach {
namespace {

Pose2d pose_at(std::size_t frame) {
  return project(waving_clip(0).poses[frame], {0.4, 0});
}

TEST(PoseSimilarity, link_sets_have_the_sizes_of_the_paper) {
  EXPECT_EQ(links(Links::Bones).size(), 14U);
  EXPECT_EQ(links(Links::BonesAndEnds).size(), 24U);
  EXPECT_EQ(links(Links::All).size(), 105U);
  EXPECT_EQ(end_effector_links().size(), 10U);
}

TEST(PoseSimilarity, directions_are_unit_vectors_over_half_a_turn) {
  const std::vector<Vec2> four = projection_directions(4);
  ASSERT_EQ(four.size(), 4U);
  EXPECT_NEAR(four[1].x, four[1].y, 1e-12);
  EXPECT_NEAR(four[2].x, 0, 1e-12);
  EXPECT_NEAR(four[3].x, -four[3].y, 1e-12);
  EXPECT_NEAR(projection_directions(2, 0.3)[0].y, std::sin(0.3), 1e-12);
}

TEST(PoseSimilarity, no_link_flips_in_the_same_pose_at_any_size_and_all_flip_upside_down) {
  const Pose2d pose = pose_at(11);
  const std::vector<Vec2> directions = projection_directions(8, 0.01);
  EXPECT_EQ(violations(pose, scaled(pose, 3), links(Links::All), directions).flipped, 0);
  const LinkCount turned = violations(pose, scaled(pose, -1), links(Links::All), directions);
  EXPECT_EQ(turned.total, 105 * 8);
  EXPECT_DOUBLE_EQ(turned.percent(), 100);
}

TEST(PoseSimilarity, one_joint_moved_past_another_is_counted_once_a_direction) {
  Pose2d a, b;
  a.seen.fill(true);
  b.seen.fill(true);
  a[Joint2d::Nose] = {1, 0};
  b[Joint2d::Nose] = {-1, 0};
  const std::vector<Link> one = {{Joint2d::Nose, Joint2d::Neck}};
  const LinkCount count = violations(a, b, one, projection_directions(2));
  EXPECT_EQ(count.flipped, 1);
  EXPECT_EQ(count.total, 2);
}

TEST(PoseSimilarity, angles_of_a_turned_pose_are_the_turn) {
  const Pose2d pose = pose_at(3);
  Pose2d turned = pose;
  for (Vec2& p : turned.positions)
    p = {std::cos(0.3) * p.x - std::sin(0.3) * p.y, std::sin(0.3) * p.x + std::cos(0.3) * p.y};
  EXPECT_NEAR(mean_squared_angle(pose, turned, links(Links::Bones)), 0.09, 1e-9);
}

TEST(PoseSimilarity, bones_of_no_length_have_no_angle) {
  Pose2d pose = pose_at(3), other = pose;
  other[Joint2d::LeftWrist] = other[Joint2d::LeftElbow];
  EXPECT_NEAR(mean_squared_angle(pose, other, links(Links::Bones)), 0, 1e-12);
  Pose2d point;
  point.seen.fill(true);
  EXPECT_EQ(mean_squared_angle(pose, point, links(Links::Bones)), 0);
}

TEST(TransferError, is_zero_for_the_truth_wherever_it_stands) {
  const Pose2d truth = pose_at(20);
  const TransferError error = transfer_error(translated(truth, {4, -2}), truth);
  EXPECT_NEAR(error.mse_lengths, 0, 1e-12);
  EXPECT_NEAR(error.mse_angles, 0, 1e-12);
  EXPECT_NEAR(error.mse_joints, 0, 1e-12);
  EXPECT_NEAR(error.oks_percent, 100, 1e-9);
}

TEST(TransferError, of_one_moved_joint_agrees_with_the_formula) {
  const Pose2d truth = pose_at(20);
  Pose2d moved = truth;
  const Vec2 box = bounding_box(truth).size();
  // Towards the box's middle, so that the box stays.
  const Vec2 by = 0.1 * glm::normalize(bounding_box(truth).centre() - truth[Joint2d::LeftElbow]);
  moved[Joint2d::LeftElbow] += by;
  if (bounding_box(moved).size() != box) GTEST_SKIP() << "the elbow holds the box in this pose";
  const TransferError error = transfer_error(moved, truth);
  EXPECT_NEAR(error.mse_joints, 0.1 / 15, 1e-9);
  const double k = 2 * 0.072;
  EXPECT_NEAR(error.oks_percent, 100 * (14 + std::exp(-0.01 / (2 * box.x * box.y * k * k))) / 15, 1e-9);
}

std::vector<Character> two_characters() {
  std::vector<Character> characters = {{"tall", {}}, {"short", {}}};
  for (const double phase : {0.0, 2.0}) {
    PoseClip clip = waving_clip(phase);
    characters[0].clips.push_back(clip);
    PoseClip small = clip;
    SyntheticBody body = average_body(1.2);
    for (Pose3d& pose : small.poses) pose = on_body(pose, clip.lengths, body);
    small.lengths = body.length_m;
    characters[1].clips.push_back(small);
  }
  return characters;
}

TEST(PairedData, the_oracle_is_exact_where_only_lengths_differ) {
  PairOptions options;
  options.frames_per_pair = 10;
  const std::vector<TransferSample> samples = paired_samples(two_characters(), options);
  EXPECT_EQ(samples.size(), 4U * 10);
  const TransferScore score = score_oracle(samples);
  EXPECT_NEAR(score.error.mse_joints, 0, 1e-9);
  EXPECT_NEAR(score.error.oks_percent, 100, 1e-6);
}

TEST(PairedData, paired_poses_are_more_alike_than_similar_ones_and_those_than_any_others) {
  const std::vector<SimilarityRow> rows = similarity_table(two_characters(), 3);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_LT(rows[0].angle_rms_bones, rows[1].angle_rms_bones);
  EXPECT_LT(rows[1].angle_rms_bones, rows[2].angle_rms_bones);
  EXPECT_LT(rows[0].four_directions[2].percent(), rows[1].four_directions[2].percent());
  EXPECT_LT(rows[1].four_directions[2].percent(), rows[2].four_directions[2].percent());
}

TEST(PairedData, one_scale_brings_every_centred_pose_within_one) {
  const std::vector<Character> characters = two_characters();
  const double units = units_per_metre(characters);
  double largest = 0;
  for (const Character& character : characters)
    for (const PoseClip& clip : character.clips)
      for (const Pose3d& pose : clip.poses) {
        const Vec2 half = 0.5 * bounding_box(scaled(project(pose, {0, 0}), units)).size();
        largest = std::max({largest, half.x, half.y});
      }
  EXPECT_LE(largest, 1 + 1e-12);
  EXPECT_GT(largest, 0.5);
}

}  // namespace
}  // namespace posecoach
