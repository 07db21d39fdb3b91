#include "core/transfer/network/transfer_network.h"

#include <array>
#include <cmath>

namespace posecoach {
namespace {

constexpr int64_t kBones = static_cast<int64_t>(kBone2dCount);
constexpr int64_t kPictureWidth = 256, kCode = 96, kCorrectionWidth = 384;

torch::nn::SiLU silu() {
  return torch::nn::SiLU();
}

const torch::Tensor& twins() {
  static const torch::Tensor indices = [] {
    // Made by whoever comes first, used in training too.
    const torch::InferenceMode ordinary(false);
    std::vector<int64_t> values;
    for (const Bone2d& bone : kBones2d) values.push_back(static_cast<int64_t>(bone.twin));
    return torch::tensor(values);
  }();
  return indices;
}

}  // namespace

void write_picture(const Pose2d& pose, double stature, float* out) {
  for (std::size_t b = 0; b < kBone2dCount; ++b) {
    const std::optional<Vec2> bone = bone_vector(pose, b);
    const Vec2 v = bone ? *bone / stature : Vec2{};
    // Times 4: numbers near one are easier to learn from.
    out[2 * b] = static_cast<float>(4 * v.x);
    out[2 * b + 1] = static_cast<float>(4 * v.y);
    out[2 * kBone2dCount + b] = static_cast<float>(4 * glm::length(v));
    out[3 * kBone2dCount + b] = bone ? 1.0F : 0.0F;
  }
}

void write_person(const BoneLengths2d& lengths, float* out) {
  for (std::size_t b = 0; b < kBone2dCount; ++b) {
    out[b] = static_cast<float>(std::log(lengths.length[b] / lengths.stature));
    out[kBone2dCount + b] = lengths.measured[b] ? 1.0F : 0.0F;
  }
}

TransferNetwork::TransferNetwork() {
  using torch::nn::Linear;
  picture_ = register_module(
      "picture", torch::nn::Sequential(Linear(kPictureNumbers + kPersonNumbers, kPictureWidth), silu(),
                                       Linear(kPictureWidth, kPictureWidth), silu()));
  person_ = register_module(
      "person", torch::nn::Sequential(Linear(2 * kPictureWidth + kPersonNumbers, kPictureWidth), silu(),
                                      Linear(kPictureWidth, kCode), silu()));
  lengths_ = register_module("lengths", torch::nn::Sequential(Linear(kCode + kPersonNumbers, kPictureWidth),
                                                              silu(), Linear(kPictureWidth, kBones)));
  correction_ = register_module(
      "correction", torch::nn::Sequential(Linear(kPictureNumbers + 4 * kBones + 2 * kCode, kCorrectionWidth),
                                          silu(), Linear(kCorrectionWidth, kCorrectionWidth), silu()));
  bones_ = register_module("bones", Linear(kCorrectionWidth, 2 * kBones));
  error_ = register_module("error", Linear(kCorrectionWidth, kBones + 1));
  touch_ = register_module("touch", Linear(kCorrectionWidth, 1));
  // Untrained, it is the closed form.
  torch::NoGradGuard no_grad;
  for (torch::nn::Linear last : {lengths_->ptr<torch::nn::LinearImpl>(2), bones_.ptr()}) {
    last->weight.mul_(0.02);
    last->bias.zero_();
  }
}

TransferNetwork::Person TransferNetwork::encode(const torch::Tensor& pictures, const torch::Tensor& person) {
  const torch::Tensor each = person.unsqueeze(1).expand({-1, pictures.size(1), -1});
  const torch::Tensor seen = picture_->forward(torch::cat({pictures, each}, 2));
  const torch::Tensor code =
      person_->forward(torch::cat({seen.mean(1), std::get<0>(seen.max(1)), person}, 1));
  const torch::Tensor longer = lengths_->forward(torch::cat({code, person}, 1));
  const torch::Tensor both_sides = 0.5 * (longer + longer.index_select(1, twins()));
  return {code, person.slice(1, 0, kBones) + both_sides};
}

TransferNetwork::Result TransferNetwork::forward(const torch::Tensor& pose, const Person& source,
                                                 const Person& identity) {
  const torch::Tensor ratio = (identity.log_lengths - source.log_lengths).clamp(-3, 3).exp();
  const torch::Tensor bones = pose.slice(1, 0, 2 * kBones).view({-1, kBones, 2}) * ratio.unsqueeze(2);
  const torch::Tensor inside = correction_->forward(torch::cat(
      {pose, bones.flatten(1), source.log_lengths, identity.log_lengths, source.code, identity.code}, 1));
  Result result;
  result.bones = (bones + bones_(inside).view({-1, kBones, 2})) / 4;
  result.expected_error = torch::nn::functional::softplus(error_(inside) - 4);
  result.touch = touch_(inside).squeeze(1);
  return result;
}

torch::Tensor joints_from_bones(const torch::Tensor& bones) {
  std::array<torch::Tensor, kJoint2dCount> joints;
  joints[index(Joint2d::MidHip)] = torch::zeros_like(bones.select(1, 0));
  for (std::size_t b = 0; b < kBone2dCount; ++b)
    joints[index(kBones2d[b].child)] =
        joints[index(kBones2d[b].parent)] + bones.select(1, static_cast<int64_t>(b));
  return torch::stack(at::TensorList(joints.data(), joints.size()), 1);
}

}  // namespace posecoach
