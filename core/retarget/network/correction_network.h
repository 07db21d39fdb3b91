// Our network: what geometry gets wrong on webcam input, as rotations of the canonical joints: a share of the
// way to what steadier smoothing says, frame by frame and joint by joint, and small rotations besides. Plain
// convolutions over time with growing reach (about two seconds in all).
#pragma once

#include "core/retarget/network/correction_frames.h"
#include "core/retarget/network/torch.h"

namespace posecoach {

struct CorrectionNetworkOptions {
  int64_t width = 128;
  int64_t kernel = 5;
};

inline constexpr char kCorrectionWeightsKind[] = "posecoach.retarget.network/2";

class CorrectionNetworkImpl : public torch::nn::Module {
 public:
  explicit CorrectionNetworkImpl(const CorrectionNetworkOptions& options = {});
  // Values [batch, kCorrectionValues, time] and what is steadier [batch, time, canonical joints,
  // kSteadyTurns, 3] -> rotation vectors [batch, time, canonical joints, 3].
  torch::Tensor forward(const torch::Tensor& values, const torch::Tensor& steadier);

  torch::Tensor mean, deviation;  // of the values, part of the weights

 private:
  int64_t kernel_;
  torch::nn::Conv1d entry_{nullptr}, exit_{nullptr};
  std::vector<torch::nn::Conv1d> reach_, mix_;
};
TORCH_MODULE(CorrectionNetwork);

// Rotation vectors to unit quaternions, w x y z, in the last dimension.
torch::Tensor quaternions_from_vectors(const torch::Tensor& vectors);
torch::Tensor quaternion_product(const torch::Tensor& a, const torch::Tensor& b);

}  // namespace posecoach
