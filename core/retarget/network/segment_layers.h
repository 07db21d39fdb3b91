// Layers that keep the six body segments apart. Features are laid out segment after segment, so a masked
// convolution between features is a grouped one; joints enter by gathering each segment's rows and leave by
// adding up what each segment says about them (a joint of several segments hears all of them, the root all
// six). The same functions as a dense layer times a mask, without the zeros.
#pragma once

#include <vector>

#include "core/retarget/network/body_layout.h"
#include "core/retarget/network/torch.h"

namespace posecoach {

inline constexpr int64_t kSegments = static_cast<int64_t>(kBodySegmentCount);

// Which rows of a layout belong to which segment. Input rows are its joints and, last, the root's path, which
// belongs to every segment.
struct SegmentRows {
  torch::Tensor rows;     // [segments, most rows of a segment], row numbers; unused places hold 0
  torch::Tensor used;     // the same shape, 1 or 0
  int64_t row_count = 0;  // joints + 1
  int64_t places = 0;     // most rows of a segment
};
SegmentRows segment_rows(const BodyLayout& layout);

// [batch, time, rows, values] -> [batch, segments * places * values, time].
torch::Tensor gather_segments(const torch::Tensor& rows, const SegmentRows& segments);

// A convolution over time that keeps segments apart and, with reflected ends, the length (divided by stride).
class SegmentConvolutionImpl : public torch::nn::Module {
 public:
  // Channels are a segment's own; `kernel` is odd.
  SegmentConvolutionImpl(int64_t channels_in, int64_t channels_out, int64_t kernel, int64_t stride);
  torch::Tensor forward(const torch::Tensor& features);

  torch::Tensor weight, bias;

 private:
  int64_t kernel_, stride_;
};
TORCH_MODULE(SegmentConvolution);

// Twice as many frames, linearly in between.
torch::Tensor doubled_in_time(const torch::Tensor& features);

}  // namespace posecoach
