#include "core/retarget/network/paper_network.h"

#include <cmath>

#include "core/base/assert.h"

namespace posecoach {
namespace {

constexpr double kLeak = 0.2;

torch::Tensor leaky(const torch::Tensor& x) {
  return torch::leaky_relu(x, kLeak);
}

// The usual sines and cosines, of the row's number.
torch::Tensor positional_encoding(int64_t rows, int64_t width) {
  torch::Tensor encoding = torch::zeros({rows, width});
  for (int64_t row = 0; row < rows; ++row)
    for (int64_t i = 0; i < width; i += 2) {
      const double angle =
          static_cast<double>(row) / std::pow(10000.0, static_cast<double>(i) / static_cast<double>(width));
      encoding[row][i] = std::sin(angle);
      encoding[row][i + 1] = std::cos(angle);
    }
  return encoding;
}

// Only the first `joints` rows of each segment: a T-pose has no root path.
torch::Tensor with_root_row(const torch::Tensor& bones) {
  return torch::cat({bones, torch::zeros_like(bones.narrow(1, 0, 1))}, 1);
}

}  // namespace

SkeletonExtractorImpl::SkeletonExtractorImpl(const BodyLayout& layout, const PaperNetworkOptions& options)
    : rows_(segment_rows(layout)) {
  first_ = register_module("first", SegmentConvolution(rows_.places * 3, options.width, 1, 1));
  second_ = register_module("second", SegmentConvolution(options.width, options.width, 1, 1));
  third_ = register_module("third", SegmentConvolution(options.width, options.width, 1, 1));
}

torch::Tensor SkeletonExtractorImpl::forward(const torch::Tensor& bones) {
  const torch::Tensor rows = with_root_row(bones).unsqueeze(1);
  return leaky(third_(leaky(second_(leaky(first_(gather_segments(rows, rows_)))))));
}

PoseAwareAttentionImpl::PoseAwareAttentionImpl(const BodyLayout& layout, const PaperNetworkOptions& options)
    : rows_(segment_rows(layout)), width_(options.width), heads_(options.heads) {
  POSECOACH_ASSERT(width_ % heads_ == 0 && width_ % 2 == 0);
  using torch::nn::Linear;
  embed_in_ = register_module("embed_in", Linear(options.input_values(), options.embedding));
  embed_out_ = register_module("embed_out", Linear(options.embedding, width_));
  query_ = register_module("query", Linear(width_, width_));
  key_ = register_module("key", Linear(width_, width_));
  value_ = register_module("value", Linear(width_, width_));
  merge_ = register_module("merge", Linear(width_, width_));
  hidden_in_ = register_module("hidden_in", Linear(width_, options.attention_hidden));
  hidden_out_ = register_module("hidden_out", Linear(options.attention_hidden, width_));
  norm_first_ = register_module("norm_first", torch::nn::LayerNorm(torch::nn::LayerNormOptions({width_})));
  norm_second_ = register_module("norm_second", torch::nn::LayerNorm(torch::nn::LayerNormOptions({width_})));
  tokens_ = register_parameter("tokens", torch::randn({kSegments, width_}) * 0.1);
  places_ = positional_encoding(rows_.row_count, width_);
  // [segments, places + 1]: 0 where the token looks, far below where it does not; first the token itself.
  sees_ = torch::cat({torch::zeros({kSegments, 1}), (1 - rows_.used) * -1e20}, 1);
}

torch::Tensor PoseAwareAttentionImpl::forward(const torch::Tensor& rows) {
  const int64_t batch = rows.size(0), time = rows.size(1), frames = batch * time;
  const int64_t of_head = width_ / heads_;
  const torch::Tensor joints =
      embed_out_(torch::relu(embed_in_(rows.reshape({frames, rows_.row_count, rows.size(3)})))) *
          std::sqrt(static_cast<double>(width_)) +
      places_;
  // Keys and values of every row once, then handed to the segments that see it; the token comes first.
  const auto handed_out = [&](torch::nn::Linear& linear) {
    const torch::Tensor of_rows = linear(joints).index_select(1, rows_.rows.flatten());
    const torch::Tensor of_tokens = linear(tokens_).view({1, kSegments, 1, width_});
    return torch::cat({of_tokens.expand({frames, kSegments, 1, width_}),
                       of_rows.view({frames, kSegments, rows_.places, width_})},
                      2)
        .view({frames, kSegments, rows_.places + 1, heads_, of_head});
  };
  const torch::Tensor query = query_(tokens_).view({1, kSegments, 1, heads_, of_head});
  const torch::Tensor scores =
      ((query * handed_out(key_)).sum(-1) + sees_.unsqueeze(-1)) / std::sqrt(static_cast<double>(of_head));
  const torch::Tensor weights = torch::softmax(scores, 2).unsqueeze(-1);
  const torch::Tensor seen = (weights * handed_out(value_)).sum(2).view({frames, kSegments, width_});
  torch::Tensor tokens = norm_first_(tokens_ + merge_(seen));
  tokens = norm_second_(tokens + hidden_out_(torch::gelu(hidden_in_(tokens))));
  return tokens.view({batch, time, kSegments * width_}).transpose(1, 2);
}

MotionExtractorImpl::MotionExtractorImpl(const BodyLayout& layout, const PaperNetworkOptions& options)
    : rows_(segment_rows(layout)) {
  attention_ = register_module("attention", PoseAwareAttention(layout, options));
  first_ = register_module("first", SegmentConvolution(options.width, options.width, options.kernel, 2));
  second_ = register_module("second", SegmentConvolution(options.width, options.width, options.kernel, 2));
  residual_ = register_module("residual", SegmentConvolution(rows_.places * options.input_values(),
                                                             options.width, options.kernel, 2));
}

torch::Tensor MotionExtractorImpl::forward(const torch::Tensor& rows) {
  POSECOACH_ASSERT(rows.size(1) % 4 == 0 && rows.size(1) >= 16);
  const torch::Tensor half = leaky(residual_(gather_segments(rows, rows_)) + first_(attention_(rows)));
  return leaky(second_(half));
}

MotionDecoderImpl::MotionDecoderImpl(const BodyLayout& layout, const PaperNetworkOptions& options)
    : joints_(layout.size()) {
  const SegmentRows rows = segment_rows(layout);
  first_ = register_module("first", SegmentConvolution(options.width, options.width, options.kernel, 1));
  second_ = register_module("second", SegmentConvolution(options.width, rows.places * 4, options.kernel, 1));
  // A place of segment s is the joint that it holds, the root's path (last row), or nothing: those are
  // added to a row that is thrown away.
  destinations_ = torch::where(rows.used > 0, rows.rows, torch::full_like(rows.rows, joints_ + 1)).flatten();
  identity_ = torch::tensor({1.0F, 0.0F, 0.0F, 0.0F}).view({1, 1, 4});
  torch::NoGradGuard no_gradient;
  second_->weight.mul_(0.2);
}

DecodedMotion MotionDecoderImpl::forward(const torch::Tensor& features) {
  const torch::Tensor full = doubled_in_time(leaky(first_(doubled_in_time(features))));
  const int64_t batch = full.size(0), time = full.size(2);
  const torch::Tensor said =
      second_(full).view({batch, destinations_.size(0), 4, time}).permute({0, 3, 1, 2});
  const torch::Tensor rows = torch::zeros({batch, time, joints_ + 2, 4}).index_add(2, destinations_, said);
  const torch::Tensor quaternions = rows.narrow(2, 1, joints_ - 1) + identity_;
  const torch::Tensor length = (quaternions.square().sum(-1, true) + 1e-8).sqrt();
  return {quaternions / length, rows.select(2, joints_).narrow(2, 0, 3)};
}

MotionDiscriminatorImpl::MotionDiscriminatorImpl(const BodyLayout& layout) {
  const int64_t channels = (layout.size() + 1) * 3;
  first_ = register_module("first", torch::nn::Conv1d(torch::nn::Conv1dOptions(channels, 256, 15)));
  second_ = register_module("second", torch::nn::Conv1d(torch::nn::Conv1dOptions(256, 128, 1)));
  third_ = register_module("third", torch::nn::Conv1d(torch::nn::Conv1dOptions(128, 1, 1)));
}

torch::Tensor MotionDiscriminatorImpl::forward(const torch::Tensor& rows) {
  const torch::Tensor channels = rows.flatten(2).transpose(1, 2);
  return torch::sigmoid(third_(leaky(second_(leaky(first_(channels))))));
}

StructureNetworkImpl::StructureNetworkImpl(BodyLayoutKind of_kind, const PaperNetworkOptions& options)
    : kind(of_kind) {
  const BodyLayout& layout = BodyLayout::of(kind);
  const int64_t joints = layout.size();
  skeleton = register_module("skeleton", SkeletonExtractor(layout, options));
  motion = register_module("motion", MotionExtractor(layout, options));
  decoder = register_module("decoder", MotionDecoder(layout, options));
  mean = register_buffer("mean", torch::zeros({joints + 1, 3}));
  deviation = register_buffer("deviation", torch::ones({joints + 1, 3}));
  input_mean = register_buffer("input_mean", torch::zeros({joints + 1, options.input_values()}));
  input_deviation = register_buffer("input_deviation", torch::ones({joints + 1, options.input_values()}));
  rest_mean = register_buffer("rest_mean", torch::zeros({joints, 3}));
  rest_deviation = register_buffer("rest_deviation", torch::ones({joints, 3}));
  root_from_parent = torch::zeros({joints, joints});
  for (int j = 0; j < layout.size(); ++j)
    for (int a = j; a != kNoJoint; a = layout.joints()[static_cast<std::size_t>(a)].parent)
      root_from_parent[j][a] = 1;
}

PaperNetworkImpl::PaperNetworkImpl(const PaperNetworkOptions& options) : options_(options) {
  constexpr std::array names = {"split28", "old_rig23", "webcam38"};
  for (std::size_t i = 0; i < structures_.size(); ++i)
    structures_[i] = register_module(names[i], StructureNetwork(kBodyLayoutKinds[i], options));
}

torch::Tensor turned_bones(const torch::Tensor& offsets, const torch::Tensor& rotations) {
  const torch::Tensor bones = offsets.narrow(1, 1, offsets.size(1) - 1).unsqueeze(1);
  const torch::Tensor w = rotations.narrow(-1, 0, 1), v = rotations.narrow(-1, 1, 3);
  const torch::Tensor across = 2 * torch::cross(v, bones.expand_as(v), -1);
  const torch::Tensor turned = bones + w * across + torch::cross(v, across, -1);
  return torch::cat({torch::zeros_like(turned.narrow(2, 0, 1)), turned}, 2);
}

}  // namespace posecoach
