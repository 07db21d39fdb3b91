// The paper's retargeting network (section 3.2): per joint structure a skeleton extractor SE, a motion
// extractor ME (pose-aware attention, masked convolutions), a decoder MD and a discriminator C. Features have
// the same shape for every structure: [batch, segments * width, frames / 4].
//
// Positions are in units of the body's chain height (BodyLayout::chain_height) and, row by row,
// standardised with one mean and deviation per structure, so that a new body needs no motion of its own.
#pragma once

#include <array>
#include <memory>

#include "core/retarget/network/segment_layers.h"

namespace posecoach {

enum class PaperInput { ParentBased, RootBased, Rotations };

struct PaperNetworkOptions {
  int64_t width = 32;      // channels of a segment
  int64_t kernel = 7;      // frames; odd
  int64_t embedding = 64;  // hidden width of the joint embedding
  int64_t heads = 2;
  int64_t attention_hidden = 64;
  PaperInput input = PaperInput::ParentBased;

  int64_t input_values() const { return input == PaperInput::Rotations ? 4 : 3; }
};

// SE: three masked layers on the T-pose.
class SkeletonExtractorImpl : public torch::nn::Module {
 public:
  SkeletonExtractorImpl(const BodyLayout& layout, const PaperNetworkOptions& options);
  // T-pose bones [batch, joints, 3] -> [batch, segments * width, 1].
  torch::Tensor forward(const torch::Tensor& bones);

 private:
  SegmentRows rows_;
  SegmentConvolution first_{nullptr}, second_{nullptr}, third_{nullptr};
};
TORCH_MODULE(SkeletonExtractor);

// Each segment's token looks at the rows of its own segment and at itself (Eq. 9); of what attention gives,
// the tokens alone are kept.
class PoseAwareAttentionImpl : public torch::nn::Module {
 public:
  PoseAwareAttentionImpl(const BodyLayout& layout, const PaperNetworkOptions& options);
  // Rows [batch, time, joints + 1, values] -> [batch, segments * width, time].
  torch::Tensor forward(const torch::Tensor& rows);

 private:
  SegmentRows rows_;
  int64_t width_, heads_;
  torch::Tensor tokens_, places_, sees_;
  torch::nn::Linear embed_in_{nullptr}, embed_out_{nullptr}, query_{nullptr}, key_{nullptr}, value_{nullptr},
      merge_{nullptr}, hidden_in_{nullptr}, hidden_out_{nullptr};
  torch::nn::LayerNorm norm_first_{nullptr}, norm_second_{nullptr};
};
TORCH_MODULE(PoseAwareAttention);

class MotionExtractorImpl : public torch::nn::Module {
 public:
  MotionExtractorImpl(const BodyLayout& layout, const PaperNetworkOptions& options);
  // Standardised rows [batch, time, joints + 1, values] -> [batch, segments * width, time / 4]; `time` is a
  // multiple of 4 and at least 16.
  torch::Tensor forward(const torch::Tensor& rows);

 private:
  SegmentRows rows_;
  PoseAwareAttention attention_{nullptr};
  SegmentConvolution first_{nullptr}, second_{nullptr}, residual_{nullptr};
};
TORCH_MODULE(MotionExtractor);

struct DecodedMotion {
  torch::Tensor rotations;  // [batch, time, joints - 1, 4], unit quaternions w x y z: how each bone is turned
  torch::Tensor root;       // [batch, time, 3], standardised
};

class MotionDecoderImpl : public torch::nn::Module {
 public:
  MotionDecoderImpl(const BodyLayout& layout, const PaperNetworkOptions& options);
  DecodedMotion forward(const torch::Tensor& features);

 private:
  int64_t joints_;
  SegmentConvolution first_{nullptr}, second_{nullptr};
  torch::Tensor destinations_;  // [segments * (places + root)], where each output row is added
  torch::Tensor identity_;      // [1, 4, 1], where rotations start
};
TORCH_MODULE(MotionDecoder);

// C: ordinary convolutions over all joints; one number a frame, 1 for a real motion.
class MotionDiscriminatorImpl : public torch::nn::Module {
 public:
  explicit MotionDiscriminatorImpl(const BodyLayout& layout);
  torch::Tensor forward(const torch::Tensor& rows);

 private:
  torch::nn::Conv1d first_{nullptr}, second_{nullptr}, third_{nullptr};
};
TORCH_MODULE(MotionDiscriminator);

// Everything that belongs to one structure.
struct StructureNetworkImpl : torch::nn::Module {
  StructureNetworkImpl(BodyLayoutKind kind, const PaperNetworkOptions& options);

  BodyLayoutKind kind;
  SkeletonExtractor skeleton{nullptr};
  MotionExtractor motion{nullptr};
  MotionDecoder decoder{nullptr};
  // Of parent-relative rows and root [joints + 1, 3], of what the extractor reads [joints + 1, values], and
  // of T-pose bones [joints, 3]; part of the weights.
  torch::Tensor mean, deviation, input_mean, input_deviation, rest_mean, rest_deviation;
  torch::Tensor root_from_parent;  // [joints, joints]: root-relative positions = this times the bones
};
TORCH_MODULE(StructureNetwork);

class PaperNetworkImpl : public torch::nn::Module {
 public:
  explicit PaperNetworkImpl(const PaperNetworkOptions& options);
  StructureNetwork& of(BodyLayoutKind kind) { return structures_[static_cast<std::size_t>(kind)]; }
  const PaperNetworkOptions& options() const { return options_; }

 private:
  PaperNetworkOptions options_;
  std::array<StructureNetwork, kBodyLayoutKinds.size()> structures_{nullptr, nullptr, nullptr};
};
TORCH_MODULE(PaperNetwork);

// The bones `offsets` [batch, joints, 3] (parent to joint, T-pose; the root's row is ignored), turned by
// rotations [batch, time, joints - 1, 4] -> [batch, time, joints, 3] with zeros for the root: positions
// relative to the parent, in world axes. The paper's forward kinematics is their sum along the chain.
torch::Tensor turned_bones(const torch::Tensor& offsets, const torch::Tensor& rotations);

}  // namespace posecoach
