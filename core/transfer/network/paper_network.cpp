#include "core/transfer/network/paper_network.h"

#include <string>

#include "core/transfer/pose2d.h"

namespace posecoach {
namespace {

constexpr int64_t kNumbers = 2 * static_cast<int64_t>(kJoint2dCount);
constexpr int64_t kWidth = 256;
constexpr int64_t kIdentityCode = 64;
constexpr int64_t kPoseBlocks = 2, kDecoderBlocks = 3, kDiscriminatorBlocks = 4;

torch::nn::ReLU relu() {
  return torch::nn::ReLU();
}

}  // namespace

TransferResidualBlock::TransferResidualBlock(int64_t width, Norm norm)
    : width_(width),
      norm_(norm),
      first_(register_module("first", torch::nn::Linear(width, width))),
      second_(register_module("second", torch::nn::Linear(width, width))) {}

torch::Tensor TransferResidualBlock::normalised(const torch::Tensor& x) const {
  return norm_ == Norm::Layer ? torch::layer_norm(x, {width_}) : x;
}

torch::Tensor TransferResidualBlock::forward(const torch::Tensor& x) {
  if (norm_ == Norm::None) return x + second_(torch::leaky_relu(first_(torch::leaky_relu(x, 0.2)), 0.2));
  return x + normalised(second_(torch::relu(normalised(first_(x)))));
}

torch::Tensor TransferResidualBlock::forward(const torch::Tensor& x, const torch::Tensor& style) {
  const std::vector<torch::Tensor> s = style.chunk(4, 1);
  const torch::Tensor inside = torch::relu(normalised(first_(x)) * (1 + s[0]) + s[1]);
  return x + normalised(second_(inside)) * (1 + s[2]) + s[3];
}

PaperTransferGenerator::PaperTransferGenerator() {
  using torch::nn::Linear;
  pose_in_ = register_module(
      "pose_in", torch::nn::Sequential(Linear(kNumbers, kWidth), relu(), Linear(kWidth, kWidth), relu()));
  identity_ = register_module(
      "identity", torch::nn::Sequential(Linear(kNumbers, kWidth), relu(), Linear(kWidth, kWidth), relu(),
                                        Linear(kWidth, kWidth), relu(), Linear(kWidth, kIdentityCode)));
  style_ = register_module(
      "style", torch::nn::Sequential(Linear(kIdentityCode, kWidth), relu(), Linear(kWidth, kIdentityCode),
                                     relu(), Linear(kIdentityCode, kDecoderBlocks * 4 * kWidth)));
  out_ =
      register_module("out", torch::nn::Sequential(Linear(kWidth, kWidth), relu(), Linear(kWidth, kNumbers)));
  for (int64_t i = 0; i < kPoseBlocks; ++i)
    pose_blocks_.push_back(
        register_module("pose_block" + std::to_string(i),
                        std::make_shared<TransferResidualBlock>(kWidth, TransferResidualBlock::Norm::Layer)));
  for (int64_t i = 0; i < kDecoderBlocks; ++i)
    decoder_blocks_.push_back(
        register_module("decoder_block" + std::to_string(i),
                        std::make_shared<TransferResidualBlock>(kWidth, TransferResidualBlock::Norm::Layer)));
}

torch::Tensor PaperTransferGenerator::encode_pose(const torch::Tensor& poses) {
  torch::Tensor x = pose_in_->forward(poses.flatten(1));
  for (const auto& block : pose_blocks_) x = block->forward(x);
  return x;
}

torch::Tensor PaperTransferGenerator::encode_identity(const torch::Tensor& pictures) {
  const int64_t count = pictures.size(0), each = pictures.size(1);
  return identity_->forward(pictures.reshape({count * each, kNumbers})).view({count, each, -1}).mean(1);
}

torch::Tensor PaperTransferGenerator::decode(const torch::Tensor& pose_code,
                                             const torch::Tensor& identity_code) {
  const std::vector<torch::Tensor> styles = style_->forward(identity_code).chunk(kDecoderBlocks, 1);
  torch::Tensor x = pose_code;
  for (std::size_t i = 0; i < decoder_blocks_.size(); ++i) x = decoder_blocks_[i]->forward(x, styles[i]);
  return out_->forward(x).view({-1, static_cast<int64_t>(kJoint2dCount), 2});
}

torch::Tensor PaperTransferGenerator::forward(const torch::Tensor& poses, const torch::Tensor& pictures) {
  return decode(encode_pose(poses), encode_identity(pictures));
}

PaperTransferDiscriminator::PaperTransferDiscriminator(int64_t identities) {
  // Not "in": archives are read as Python.
  in_ = register_module("entry", torch::nn::Linear(kNumbers, kWidth));
  for (int64_t i = 0; i < kDiscriminatorBlocks; ++i)
    blocks_.push_back(
        register_module("block" + std::to_string(i),
                        std::make_shared<TransferResidualBlock>(kWidth, TransferResidualBlock::Norm::None)));
  classes_ = register_module("classes", torch::nn::Linear(kWidth, identities));
}

PaperTransferDiscriminator::Answer PaperTransferDiscriminator::forward(const torch::Tensor& poses,
                                                                       const torch::Tensor& identities) {
  torch::Tensor x = in_(poses.flatten(1));
  for (const auto& block : blocks_) x = block->forward(x);
  const torch::Tensor all = classes_(torch::leaky_relu(x, 0.2));
  return {all.gather(1, identities.unsqueeze(1)).squeeze(1), x};
}

}  // namespace posecoach
