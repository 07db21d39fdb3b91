#include "core/transfer/network/losses.h"

#include <gtest/gtest.h>

namespace posecoach {
namespace {

constexpr double kSigma = 0.05;

// All joints at the origin but the nose, so that one link along x is all that counts.
torch::Tensor nose_at(double x) {
  torch::Tensor pose = torch::zeros({1, 15, 2}, torch::kFloat64);
  pose[0][static_cast<int64_t>(Joint2d::Nose)][0] = x;
  return pose;
}

LinkProjection one_link() {
  return LinkProjection({{Joint2d::Nose, Joint2d::Neck}}, {Vec2{1, 0}});
}

struct LossAndSlope {
  double loss, slope;
};

LossAndSlope link_loss(double before, double after) {
  torch::Tensor result = nose_at(after).set_requires_grad(true);
  const torch::Tensor loss = virtual_link_loss(nose_at(before), result, one_link(), kSigma);
  loss.backward();
  return {loss.item<double>(), result.grad()[0][static_cast<int64_t>(Joint2d::Nose)][0].item<double>()};
}

TEST(VirtualLinkLoss, pulls_joints_together_that_were_together) {
  const LossAndSlope found = link_loss(0.03, 0.2);
  EXPECT_NEAR(found.loss, 0.04, 1e-7);  // squared
  EXPECT_NEAR(found.slope, 0.4, 1e-7);
}

TEST(VirtualLinkLoss, wants_the_lower_joint_lower_by_sigma) {
  const LossAndSlope flipped = link_loss(-0.3, 0.2), near = link_loss(-0.3, -0.02),
                     kept = link_loss(-0.3, -0.1);
  EXPECT_NEAR(flipped.loss, 0.25, 1e-7);
  EXPECT_NEAR(flipped.slope, 1, 1e-7);
  EXPECT_NEAR(near.loss, 0.03, 1e-7);
  EXPECT_NEAR(near.slope, 1, 1e-7);
  EXPECT_EQ(kept.loss, 0);
  EXPECT_EQ(kept.slope, 0);
}

TEST(VirtualLinkLoss, wants_the_higher_joint_higher_by_sigma) {
  const LossAndSlope flipped = link_loss(0.3, -0.2), near = link_loss(0.3, 0.02), kept = link_loss(0.3, 0.1);
  EXPECT_NEAR(flipped.loss, 0.25, 1e-7);
  EXPECT_NEAR(flipped.slope, -1, 1e-7);
  EXPECT_NEAR(near.loss, 0.03, 1e-7);
  EXPECT_EQ(kept.loss, 0);
  EXPECT_EQ(kept.slope, 0);
}

TEST(VirtualLinkLoss, sums_over_directions_and_averages_over_links_and_poses) {
  const torch::Tensor before = torch::cat({nose_at(0.3), nose_at(0.3)}),
                      after = torch::cat({nose_at(-0.2), nose_at(0.3)});
  const LinkProjection links({{Joint2d::Nose, Joint2d::Neck}, {Joint2d::LeftHip, Joint2d::RightHip}},
                             {Vec2{1, 0}, Vec2{-1, 0}});
  // 0.25 along each of two directions, one of two links, one of two poses.
  EXPECT_NEAR(virtual_link_loss(before, after, links, kSigma).item<double>(), 2 * 0.25 / 2 / 2, 1e-7);
}

TEST(VirtualLinkLoss, slope_agrees_with_differences_for_all_links) {
  torch::manual_seed(3);
  const LinkProjection all(links(Links::All), projection_directions(4));
  const torch::Tensor before = torch::randn({2, 15, 2}, torch::kFloat64);
  torch::Tensor after = (before + 0.3 * torch::randn({2, 15, 2}, torch::kFloat64)).set_requires_grad(true);
  virtual_link_loss(before, after, all, kSigma).backward();
  const double step = 1e-6;
  for (int64_t joint = 0; joint < 15; joint += 4) {
    torch::Tensor up = after.detach().clone(), down = after.detach().clone();
    up[1][joint][0] += step;
    down[1][joint][0] -= step;
    const double slope =
        (virtual_link_loss(before, up, all, kSigma) - virtual_link_loss(before, down, all, kSigma))
            .item<double>() /
        (2 * step);
    EXPECT_NEAR(after.grad()[1][joint][0].item<double>(), slope, 1e-5) << joint;
  }
}

TEST(RankingLoss, is_the_logistic_one) {
  const double flipped = ranking_loss(nose_at(0.3), nose_at(-0.2), one_link(), kSigma).item<double>();
  EXPECT_NEAR(flipped, std::log(1 + std::exp(0.2)), 1e-7);
  EXPECT_NEAR(ranking_loss(nose_at(-0.3), nose_at(-0.2), one_link(), kSigma).item<double>(),
              std::log(1 + std::exp(-0.2)), 1e-7);
  EXPECT_NEAR(ranking_loss(nose_at(0.01), nose_at(0.2), one_link(), kSigma).item<double>(), 0.04, 1e-7);
}

TEST(AngleLoss, is_one_minus_the_cosine_of_every_bones_turn) {
  torch::manual_seed(4);
  const torch::Tensor before = torch::randn({3, 15, 2}, torch::kFloat64);
  const double turn = 0.7;
  const torch::Tensor rotation =
      torch::tensor({{std::cos(turn), std::sin(turn)}, {-std::sin(turn), std::cos(turn)}}, torch::kFloat64);
  EXPECT_NEAR(angle_loss(before, 2.5 * torch::matmul(before, rotation)).item<double>(), 1 - std::cos(turn),
              1e-9);
  EXPECT_NEAR(angle_loss(before, 3 * before).item<double>(), 0, 1e-9);
  EXPECT_NEAR(angle_loss(before, -before).item<double>(), 2, 1e-9);
}

TEST(AngleLoss, slope_turns_one_bone_as_expected) {
  torch::Tensor before = torch::zeros({1, 15, 2}, torch::kFloat64);
  before[0][static_cast<int64_t>(Joint2d::Nose)][0] = 1;  // the only bone with a length: neck to nose
  torch::Tensor after = torch::zeros({1, 15, 2}, torch::kFloat64);
  after[0][static_cast<int64_t>(Joint2d::Nose)][1] = 2;  // a quarter turn
  after.set_requires_grad(true);
  const torch::Tensor loss = angle_loss(before, after);
  loss.backward();
  EXPECT_NEAR(loss.item<double>(), 1.0 / 14, 1e-9);
  EXPECT_NEAR(after.grad()[0][0][0].item<double>(), -0.5 / 14, 1e-9);
  EXPECT_NEAR(after.grad()[0][0][1].item<double>(), 0, 1e-9);
}

TEST(AngleLoss, of_bones_without_length_is_nothing_and_its_slope_finite) {
  torch::Tensor after = torch::zeros({1, 15, 2}, torch::kFloat64).set_requires_grad(true);
  const torch::Tensor loss = angle_loss(torch::ones({1, 15, 2}, torch::kFloat64), after);
  loss.backward();
  EXPECT_EQ(loss.item<double>(), 0);
  EXPECT_TRUE(torch::isfinite(after.grad()).all().item<bool>());
}

}  // namespace
}  // namespace posecoach
