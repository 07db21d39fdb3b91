// The networks of Zheng et al. (2021), after FUNIT, on poses as vectors of 30 numbers instead of pictures.
#pragma once

#include <vector>

#include "core/transfer/network/torch.h"

namespace posecoach {

// x + second(relu(first(norm(x)))): the norm's scale and bias come from outside where given (AdaIN).
class TransferResidualBlock : public torch::nn::Module {
 public:
  enum class Norm { None, Layer };
  TransferResidualBlock(int64_t width, Norm norm);
  torch::Tensor forward(const torch::Tensor& x);
  // `style` [batch, 4 * width]: scale and bias of both norms.
  torch::Tensor forward(const torch::Tensor& x, const torch::Tensor& style);

 private:
  torch::Tensor normalised(const torch::Tensor& x) const;
  int64_t width_;
  Norm norm_;
  torch::nn::Linear first_, second_;
};

// G: a pose encoder (normalised, so that it forgets the person's size), an identity encoder (not normalised;
// the codes of several pictures are averaged), and a decoder of AdaIN residual blocks.
class PaperTransferGenerator : public torch::nn::Module {
 public:
  PaperTransferGenerator();
  torch::Tensor encode_pose(const torch::Tensor& poses);         // [N, 15, 2] -> [N, width]
  torch::Tensor encode_identity(const torch::Tensor& pictures);  // [N, K, 15, 2] -> [N, code]
  torch::Tensor decode(const torch::Tensor& pose_code, const torch::Tensor& identity_code);  // -> [N, 15, 2]
  torch::Tensor forward(const torch::Tensor& poses, const torch::Tensor& pictures);

 private:
  torch::nn::Sequential pose_in_{nullptr}, identity_{nullptr}, style_{nullptr}, out_{nullptr};
  std::vector<std::shared_ptr<TransferResidualBlock>> pose_blocks_, decoder_blocks_;
};

// D: one answer a known identity (only that of the wanted identity counts), and the features before it.
class PaperTransferDiscriminator : public torch::nn::Module {
 public:
  explicit PaperTransferDiscriminator(int64_t identities);
  struct Answer {
    torch::Tensor score;     // [N]
    torch::Tensor features;  // [N, width]
  };
  Answer forward(const torch::Tensor& poses, const torch::Tensor& identities);

 private:
  torch::nn::Linear in_{nullptr}, classes_{nullptr};
  std::vector<std::shared_ptr<TransferResidualBlock>> blocks_;
};

}  // namespace posecoach
