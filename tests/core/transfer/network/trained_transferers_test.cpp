#include "core/transfer/network/trained_transferers.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/embedded.h"
#include "core/base/file.h"
#include "core/transfer/evaluation.h"
#include "core/transfer/trained.h"
#include "core/transfer/training.h"
#include "tests/core/transfer/test_people.h"
#include "tests/support/temporary_folder.h"

namespace posecoach {
namespace {

POSECOACH_EMBEDDED(transfer_paper_weights)

std::vector<TransferSample> samples_of(std::size_t count, std::size_t pictures) {
  const PoseClipPool pool(waving_clips(4));
  std::mt19937_64 random(11);
  SampleOptions options;
  options.variety = SyntheticVariety::Common;
  options.source_pictures = 30;
  options.identity_pictures = pictures;
  std::vector<TransferSample> samples;
  for (std::size_t i = 0; i < count; ++i) samples.push_back(random_sample(pool, random, options));
  return samples;
}

class EveryTrained : public testing::TestWithParam<TransferMethod> {
 protected:
  void SetUp() override {
    Result<std::unique_ptr<Transferer>> made = make_transferer(GetParam());
    ASSERT_TRUE(made.has_value()) << made.error().message;
    transferer_ = *std::move(made);
  }
  std::unique_ptr<Transferer> transferer_;
};

TEST_P(EveryTrained, gives_back_a_pose_of_the_same_person_within_its_error) {
  const bool ours = GetParam() == TransferMethod::Network;
  TransferScorer scorer(kPaperUnitsPerMetre);
  for (TransferSample& sample : samples_of(40, 1)) {
    sample.truth = sample.source.front();
    ASSERT_TRUE(transferer_->set_people(sample.source, sample.source).has_value());
    const Pose2d result = transferer_->transfer(sample.source.front()).pose;
    scorer.add(sample, &result);
  }
  EXPECT_LT(scorer.score().error.mse_joints, ours ? 0.02 : 0.07);
}

TEST_P(EveryTrained, is_nearer_to_the_truth_than_scaling) {
  const std::vector<TransferSample> samples = samples_of(80, 8);
  const auto scale = make_transferer(TransferMethod::Scale);
  ASSERT_TRUE(scale.has_value());
  const TransferScore trained = score(*transferer_, samples), simple = score(**scale, samples);
  EXPECT_LT(trained.error.mse_joints, simple.error.mse_joints);
  EXPECT_GT(trained.error.oks_percent, simple.error.oks_percent);
}

TEST_P(EveryTrained, does_not_care_about_the_pictures_scales) {
  TransferSample sample = samples_of(1, 2).front();
  ASSERT_TRUE(transferer_->set_people(sample.source, sample.identity).has_value());
  const Pose2d before = transferer_->transfer(sample.source.front()).pose;
  for (Pose2d& picture : sample.source) picture = scaled(picture, 300);
  for (Pose2d& picture : sample.identity) picture = scaled(picture, 7);
  ASSERT_TRUE(transferer_->set_people(sample.source, sample.identity).has_value());
  const Pose2d after = transferer_->transfer(sample.source.front()).pose;
  EXPECT_LT(transfer_error(scaled(after, 1.0 / 7), before).mse_joints, 1e-4);
}

TEST_P(EveryTrained, takes_missing_joints_bones_of_no_length_and_one_joint_repeated) {
  const TransferSample sample = samples_of(1, 1).front();
  ASSERT_TRUE(transferer_->set_people(sample.source, sample.identity).has_value());
  Pose2d missing = sample.source.front(), flat = missing, point = missing, nothing = missing;
  for (const Joint2d joint : {Joint2d::LeftWrist, Joint2d::LeftElbow, Joint2d::MidHip, Joint2d::LeftHip})
    missing.seen[index(joint)] = false;
  flat[Joint2d::RightKnee] = flat[Joint2d::RightHip];
  for (Vec2& p : point.positions) p = {3, 4};
  nothing.seen.fill(false);
  for (const Pose2d& strange : {missing, flat, point, nothing}) {
    const TransferredPose result = transferer_->transfer(strange);
    EXPECT_TRUE(result.pose.is_complete());
    for (const Vec2& p : result.pose.positions) EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
  }
  EXPECT_FALSE(transferer_->transfer(missing).doubts.empty());
  EXPECT_EQ(transferer_->set_people(std::vector<Pose2d>{point}, sample.identity).error().code,
            ErrorCode::Incomplete);
}

INSTANTIATE_TEST_SUITE_P(All, EveryTrained, testing::Values(TransferMethod::Paper, TransferMethod::Network),
                         [](const auto& method) { return std::string(to_string(method.param)); });

TEST(NetworkTransfer, of_a_mirrored_pose_is_the_mirrored_answer) {
  auto network = make_transferer(TransferMethod::Network);
  ASSERT_TRUE(network.has_value());
  const TransferSample sample = samples_of(1, 3).front();
  std::vector<Pose2d> source, identity;
  for (const Pose2d& picture : sample.source) source.push_back(mirrored(picture));
  for (const Pose2d& picture : sample.identity) identity.push_back(mirrored(picture));
  ASSERT_TRUE((*network)->set_people(sample.source, sample.identity).has_value());
  const Pose2d straight = (*network)->transfer(sample.source.front()).pose;
  ASSERT_TRUE((*network)->set_people(source, identity).has_value());
  const Pose2d in_mirror = mirrored((*network)->transfer(source.front()).pose);
  for (std::size_t i = 0; i < kJoint2dCount; ++i)
    EXPECT_NEAR(glm::length(straight.positions[i] - in_mirror.positions[i]), 0, 1e-5);
}

TEST(NetworkTransfer, expects_larger_errors_where_joints_are_missing) {
  auto network = make_transferer(TransferMethod::Network);
  ASSERT_TRUE(network.has_value());
  double whole = 0, missing = 0;
  for (const TransferSample& sample : samples_of(20, 8)) {
    ASSERT_TRUE((*network)->set_people(sample.source, sample.identity).has_value());
    Pose2d pose = sample.source.front();
    whole += (*network)->transfer(pose).expected_error[index(Joint2d::LeftWrist)];
    pose.seen[index(Joint2d::LeftWrist)] = pose.seen[index(Joint2d::LeftElbow)] = false;
    missing += (*network)->transfer(pose).expected_error[index(Joint2d::LeftWrist)];
  }
  EXPECT_GT(missing, 2 * whole);
}

TEST(PaperNetwork, codes_of_one_person_are_nearer_than_codes_of_two) {
  auto generator = std::make_shared<PaperTransferGenerator>();
  ASSERT_TRUE(read_transfer_weights(*generator, transfer_paper_weights(), "transfer-paper.pt", kPaperKind)
                  .has_value());
  const torch::InferenceMode inference;
  std::mt19937_64 random(2);
  const PoseClipPool pool(waving_clips(4));
  SampleOptions options;
  options.identity_pictures = 12;
  std::vector<torch::Tensor> people;
  for (int person = 0; person < 12; ++person) {
    const TransferSample sample = random_sample(pool, random, options);
    std::vector<torch::Tensor> codes;
    for (const Pose2d& picture : sample.identity)
      codes.push_back(generator->encode_identity(
          paper_tensor(picture, kPaperUnitsPerMetre * kPaperStature_m / sample.stature_m)
              .view({1, 1, 15, 2}))[0]);
    people.push_back(torch::stack(codes));
  }
  double within = 0, between = 0;
  for (std::size_t i = 0; i < people.size(); ++i) {
    within += torch::cdist(people[i], people[i]).mean().item<double>();
    between += torch::cdist(people[i], people[(i + 1) % people.size()]).mean().item<double>();
  }
  EXPECT_LT(within, 0.9 * between);
}

TEST(TransferWeights, that_are_no_weights_or_of_another_network_are_refused) {
  for (const TransferMethod method : {TransferMethod::Paper, TransferMethod::Network}) {
    const auto loaded = load_transferer(method, "not weights at all", "broken.pt");
    ASSERT_FALSE(loaded.has_value());
    EXPECT_EQ(loaded.error().code, ErrorCode::Malformed);
    EXPECT_NE(loaded.error().message.find("broken.pt"), std::string::npos);
  }
  EXPECT_FALSE(load_transferer(TransferMethod::Network, transfer_paper_weights(), "other.pt").has_value());
  EXPECT_FALSE(
      load_transferer(TransferMethod::Paper, transfer_paper_weights().substr(0, 5000), "cut.pt").has_value());
}

class Training : public testing::TestWithParam<TransferMethod> {
 protected:
  TransferTrainingOptions options(long iterations) const {
    TransferTrainingOptions options;
    options.weights = folder_.path() / "weights.pt";
    options.minutes = 10;
    options.iterations = iterations;
    return options;
  }
  static Result<TransferTrainingSummary> train(const TransferTrainingOptions& options) {
    return GetParam() == TransferMethod::Paper ? train_paper_transfer(waving_clips(8), options, {})
                                               : train_network_transfer(waving_clips(8), options);
  }
  TemporaryFolder folder_;
};

TEST_P(Training, writes_weights_a_log_and_curves_and_goes_on_where_it_was) {
  const auto first = train(options(3));
  ASSERT_TRUE(first.has_value()) << first.error().message;
  EXPECT_EQ(first->iterations, 3);
  TransferTrainingOptions more = options(5);
  more.resume = true;
  const auto second = train(more);
  ASSERT_TRUE(second.has_value()) << second.error().message;
  EXPECT_EQ(second->iterations, 5);
  EXPECT_GE(second->best_score, first->best_score);
  const auto log = read_file(folder_.path() / "weights.csv");
  ASSERT_TRUE(log.has_value());
  EXPECT_EQ(std::count(log->begin(), log->end(), '\n'), 3);
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "weights.png"));
  const auto weights = read_file(folder_.path() / "weights.pt");
  ASSERT_TRUE(weights.has_value());
  EXPECT_TRUE(load_transferer(GetParam(), *weights, "weights.pt").has_value());
}

TEST_P(Training, stops_when_told_and_keeps_what_it_has) {
  TransferTrainingOptions stopped = options(1000000);
  int asked = 0;
  stopped.progress = [&](std::string_view, double) { return ++asked < 2; };
  const auto summary = train(stopped);
  ASSERT_TRUE(summary.has_value()) << summary.error().message;
  EXPECT_TRUE(summary->stopped);
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "weights.checkpoint"));
}

TEST_P(Training, refuses_a_checkpoint_that_is_none) {
  ASSERT_TRUE(write_file_atomically(folder_.path() / "weights.checkpoint", "nonsense").has_value());
  TransferTrainingOptions resumed = options(5);
  resumed.resume = true;
  const auto summary = train(resumed);
  ASSERT_FALSE(summary.has_value());
  EXPECT_EQ(summary.error().code, ErrorCode::Malformed);
}

INSTANTIATE_TEST_SUITE_P(Both, Training, testing::Values(TransferMethod::Paper, TransferMethod::Network),
                         [](const auto& method) { return std::string(to_string(method.param)); });

TEST(TransferTraining, wants_enough_motions_to_hold_some_out) {
  TransferTrainingOptions options;
  options.weights = std::filesystem::path(testing::TempDir()) / "never.pt";
  const auto summary = train_network_transfer(waving_clips(2), options);
  ASSERT_FALSE(summary.has_value());
  EXPECT_EQ(summary.error().code, ErrorCode::Incomplete);
}

}  // namespace
}  // namespace posecoach
