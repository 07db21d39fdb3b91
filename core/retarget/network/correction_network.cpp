#include "core/retarget/network/correction_network.h"

#include <array>
#include <string>

namespace posecoach {
namespace {

constexpr std::array<int64_t, 5> kDilations = {1, 2, 4, 8, 1};

}  // namespace

CorrectionNetworkImpl::CorrectionNetworkImpl(const CorrectionNetworkOptions& options)
    : kernel_(options.kernel) {
  using torch::nn::Conv1d;
  using torch::nn::Conv1dOptions;
  entry_ = register_module("entry", Conv1d(Conv1dOptions(kCorrectionValues, options.width, 1)));
  for (std::size_t i = 0; i < kDilations.size(); ++i) {
    const std::string number = std::to_string(i);
    reach_.push_back(register_module(
        "reach" + number,
        Conv1d(Conv1dOptions(options.width, options.width, kernel_).dilation(kDilations[i]))));
    mix_.push_back(register_module("mix" + number, Conv1d(Conv1dOptions(options.width, options.width, 1))));
  }
  const int64_t joints = static_cast<int64_t>(kHumanoidJointCount);
  exit_ = register_module("exit", Conv1d(Conv1dOptions(options.width, joints * (3 + kSteadyTurns + 1), 1)));
  mean = register_buffer("mean", torch::zeros({kCorrectionValues, 1}));
  deviation = register_buffer("deviation", torch::ones({kCorrectionValues, 1}));
  torch::NoGradGuard no_gradient;
  exit_->weight.mul_(0.01);
  exit_->bias.zero_();
}

torch::Tensor CorrectionNetworkImpl::forward(const torch::Tensor& values, const torch::Tensor& steadier) {
  torch::Tensor x = entry_((values - mean) / deviation);
  for (std::size_t i = 0; i < kDilations.size(); ++i) {
    const int64_t side = kDilations[i] * (kernel_ / 2);
    const torch::Tensor padded = torch::replication_pad1d(torch::relu(x), {side, side});
    x = x + mix_[i](torch::relu(reach_[i](padded)));
  }
  const torch::Tensor out = exit_(torch::relu(x)).transpose(1, 2);
  const torch::Tensor of_joint =
      out.reshape({out.size(0), out.size(1), static_cast<int64_t>(kHumanoidJointCount), -1});
  // Of the usual smoothing and of the steadier ones, as much as is good for this joint now.
  const torch::Tensor shares = torch::softmax(of_joint.narrow(3, 3, kSteadyTurns + 1), 3);
  return of_joint.narrow(3, 0, 3) + (shares.narrow(3, 1, kSteadyTurns).unsqueeze(4) * steadier).sum(3);
}

torch::Tensor quaternions_from_vectors(const torch::Tensor& vectors) {
  const torch::Tensor angle = (vectors.square().sum(-1, true) + 1e-12).sqrt();
  return torch::cat({torch::cos(angle / 2), vectors * (torch::sin(angle / 2) / angle)}, -1);
}

torch::Tensor quaternion_product(const torch::Tensor& a, const torch::Tensor& b) {
  const torch::Tensor aw = a.narrow(-1, 0, 1), av = a.narrow(-1, 1, 3);
  const torch::Tensor bw = b.narrow(-1, 0, 1), bv = b.narrow(-1, 1, 3);
  return torch::cat({aw * bw - (av * bv).sum(-1, true), aw * bv + bw * av + torch::cross(av, bv, -1)}, -1);
}

}  // namespace posecoach
