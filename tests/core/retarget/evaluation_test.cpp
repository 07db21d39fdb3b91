#include "core/retarget/evaluation.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <glm/geometric.hpp>

#include "core/body/standard_body.h"
#include "core/motion/bundled_motion.h"
#include "core/motion/motion_file.h"
#include "core/retarget/experiments.h"
#include "tests/core/retarget/motions.h"
#include "tests/support/shared_data.h"

namespace posecoach {
namespace {

TEST(Evaluation, a_motion_has_no_error_against_itself) {
  const Motion motion = random_motion(make_standard_body(), 10, 1);
  const PairErrors errors = compare(motion, motion, motion);
  EXPECT_EQ(errors.root, 0);
  EXPECT_EQ(errors.local, 0);
  EXPECT_EQ(errors.global, 0);
  EXPECT_LT(errors.bone_length, 1e-9);
}

TEST(Evaluation, a_shifted_body_errs_in_the_world_only_by_its_square_over_the_height_squared) {
  const Motion truth = random_motion(make_standard_body(), 10, 2);
  const Vec3 shift(0.1, 0.2, -0.2);
  const PairErrors errors = compare(transformed(truth, Quat(1, 0, 0, 0), shift), truth, truth);
  const double height = chain_height(truth.skeleton());
  const double expected = glm::dot(shift, shift) / 3 / (height * height);
  EXPECT_NEAR(errors.root, expected, 1e-12);
  EXPECT_NEAR(errors.global, expected, 1e-12);
  EXPECT_NEAR(errors.local, 0, 1e-12);
  EXPECT_NEAR(errors.eq16_cm, 100 * glm::dot(shift, shift) / height, 1e-9);
}

TEST(Evaluation, the_height_is_the_chain_from_toe_to_root_to_head) {
  const Skeleton body = make_standard_body();
  double chain = 0;
  using enum HumanoidJoint;
  for (const HumanoidJoint role :
       {LeftHip, LeftKnee, LeftAnkle, LeftToe, LeftToeTip, Spine, SpineMiddle, Chest, Neck, Head, HeadTop})
    chain += body.bone_length(body.find(role));
  EXPECT_NEAR(chain_height(body), chain, 1e-12);
}

TEST(Evaluation, pairs_go_both_ways_and_structures_are_told_by_their_joints) {
  const Skeleton small = make_standard_body({.height_m = 1.5}), tall = make_standard_body({.height_m = 1.9});
  const Motion swing = resample(*bundled_motion("swing"), 60);
  const Motion on_webcam = retarget(swing, test_landmark_body(1))->motion;
  const std::vector<CharacterMotion> motions = {{"small", "swing", retarget(swing, small)->motion},
                                                {"tall", "swing", retarget(swing, tall)->motion},
                                                {"webcam", "swing", on_webcam},
                                                {"tall", "alone", swing}};
  const auto evaluation = evaluate_retarget(motions);
  ASSERT_TRUE(evaluation) << evaluation.error().message;
  EXPECT_EQ(evaluation->rows.size(), 20U);
  for (const EvaluationRow& row : evaluation->rows) {
    EXPECT_EQ(row.pairs, row.structure == Structure::Intra ? 2 : 4);
    const bool is_plain_copy = (row.method == "rotation" || row.method == "network") &&
                               row.contacts == Contacts::Off && row.structure == Structure::Intra;
    EXPECT_TRUE(!is_plain_copy || row.mean.global < 1e-12) << row.mean.global;
    EXPECT_TRUE(row.method == "scale" || row.mean.bone_length < 1e-9);
    ASSERT_TRUE(row.mean.grip_cm);
    EXPECT_TRUE(row.contacts == Contacts::Off || *row.mean.grip_cm < 0.3);
  }
}

TEST(Evaluation, without_a_pair_there_is_nothing_to_evaluate) {
  const auto evaluation = evaluate_retarget({{"a", "walk", random_motion(make_standard_body(), 5, 3)}});
  ASSERT_FALSE(evaluation);
  EXPECT_EQ(evaluation.error().code, ErrorCode::Incomplete);
}

TEST(Experiments, answers_part_by_the_history_of_rotations_and_not_by_that_of_positions) {
  const Motion swing = resample(*bundled_motion("swing"), 30);
  const Skeleton body = with_sloped_limbs(make_standard_body({.height_m = 1.6}), 0.15);
  EvaluatedMethod by_file{"file", {}}, by_positions{"positions", {}};
  by_positions.options.rotations = RotationSource::Positions;
  const auto rows = part_by_history(swing, body, {by_file, by_positions});
  ASSERT_TRUE(rows) << rows.error().message;
  EXPECT_GT((*rows)[0].max_cm, 2);
  EXPECT_LT((*rows)[1].max_cm, 1e-6);
}

// The errors that a separate computation found on pairs of this kind are the mark to reach.
TEST(Evaluation, real_characters_doing_the_same_motion) {
  namespace fs = std::filesystem;
  const auto data = shared_data("data/paired");
  if (!data) GTEST_SKIP() << "no paired characters here";
  std::vector<CharacterMotion> motions;
  for (const auto& character : fs::directory_iterator(*data))
    for (const auto& file : fs::directory_iterator(character)) {
      auto read = read_motion_file(file.path());
      ASSERT_TRUE(read) << read.error().message;
      motions.push_back({character.path().filename(), file.path().stem(), read->motion});
    }
  for (const RotationSource source : {RotationSource::FileFirst, RotationSource::Positions}) {
    EvaluationOptions options;
    options.rotations = source;
    const auto evaluation = evaluate_retarget(motions, options);
    ASSERT_TRUE(evaluation) << evaluation.error().message;
    for (const EvaluationRow& row : evaluation->rows) {
      if (row.contacts == Contacts::On || row.method == "scale") continue;
      const bool intra = row.structure == Structure::Intra;
      EXPECT_LT(row.mean.bone_length, 1e-3);
      if (row.method == "network") {
        EXPECT_LT(row.mean.global, intra ? 5.0e-4 : 6.0e-4);
        EXPECT_LT(row.mean.local, intra ? 1.2e-4 : 4.4e-5);
        EXPECT_EQ(row.mean.beyond_limits_degrees, 0);
      } else if (row.method == "rotation") {
        EXPECT_LT(row.mean.global, intra ? 6.9e-4 : 8.0e-4);
        EXPECT_LT(row.mean.local, intra ? 1.0e-4 : 6e-5);
      } else if (row.method == "direction") {
        EXPECT_LT(row.mean.global, intra ? 9.7e-4 : 1.1e-3);
        EXPECT_LT(row.mean.local, intra ? 4.5e-4 : 4.6e-4);
      } else if (intra) {
        EXPECT_LT(row.mean.local, 1.6e-3) << row.method;
      }
    }
  }
}

}  // namespace
}  // namespace posecoach
