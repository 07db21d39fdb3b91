#include "core/retarget/network/segment_layers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace posecoach {

SegmentRows segment_rows(const BodyLayout& layout) {
  std::vector<std::vector<int>> rows;
  for (std::size_t s = 0; s < kBodySegmentCount; ++s) {
    rows.push_back(layout.joints_of(static_cast<BodySegment>(s)));
    rows.back().push_back(layout.size());
  }
  SegmentRows made;
  made.row_count = layout.size() + 1;
  for (const auto& segment : rows) made.places = std::max(made.places, static_cast<int64_t>(segment.size()));
  made.rows = torch::zeros({kSegments, made.places}, torch::kLong);
  made.used = torch::zeros({kSegments, made.places});
  for (std::size_t s = 0; s < rows.size(); ++s)
    for (std::size_t i = 0; i < rows[s].size(); ++i) {
      made.rows[static_cast<int64_t>(s)][static_cast<int64_t>(i)] = rows[s][i];
      made.used[static_cast<int64_t>(s)][static_cast<int64_t>(i)] = 1;
    }
  return made;
}

torch::Tensor gather_segments(const torch::Tensor& rows, const SegmentRows& segments) {
  const int64_t batch = rows.size(0), time = rows.size(1), values = rows.size(3);
  const torch::Tensor taken = rows.index_select(2, segments.rows.flatten()) *
                              segments.used.flatten().unsqueeze(1);  // [batch, time, places, values]
  return taken.reshape({batch, time, kSegments * segments.places * values}).transpose(1, 2);
}

SegmentConvolutionImpl::SegmentConvolutionImpl(int64_t channels_in, int64_t channels_out, int64_t kernel,
                                               int64_t stride)
    : kernel_(kernel), stride_(stride) {
  const double limit = 1 / std::sqrt(static_cast<double>(channels_in * kernel));
  weight = register_parameter(
      "weight", torch::empty({kSegments * channels_out, channels_in, kernel}).uniform_(-limit, limit));
  bias = register_parameter("bias", torch::empty({kSegments * channels_out}).uniform_(-limit, limit));
}

torch::Tensor SegmentConvolutionImpl::forward(const torch::Tensor& features) {
  const int64_t padding = kernel_ / 2;
  const torch::Tensor padded = torch::reflection_pad1d(features, {padding, padding});
  const std::array<int64_t, 1> stride = {stride_}, no_padding = {0}, no_dilation = {1};
  return torch::conv1d(padded, weight, bias, stride, no_padding, no_dilation, kSegments);
}

torch::Tensor doubled_in_time(const torch::Tensor& features) {
  return torch::upsample_linear1d(features, {features.size(2) * 2}, false);
}

}  // namespace posecoach
