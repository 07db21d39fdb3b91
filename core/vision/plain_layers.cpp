#include "core/vision/plain_layers.h"

#include <algorithm>
#include <cmath>

namespace posecoach {
namespace {

struct PictureSize {
  explicit PictureSize(const std::vector<int>& shape)
      : rows(static_cast<std::size_t>(shape[1])),
        columns(static_cast<std::size_t>(shape[2])),
        channels(static_cast<std::size_t>(shape[3])) {}
  std::size_t rows;
  std::size_t columns;
  std::size_t channels;
};

}  // namespace

void run_pad(const Layer& layer, const std::vector<int>& in_shape, std::span<const float> in,
             std::span<float> out) {
  const PictureSize size(in_shape);
  const auto left = static_cast<std::size_t>(layer.padding.left);
  const auto top = static_cast<std::size_t>(layer.padding.top);
  const std::size_t out_columns = left + size.columns + static_cast<std::size_t>(layer.padding.right);
  const std::size_t out_channels = size.channels + static_cast<std::size_t>(layer.padding.channels);
  std::fill(out.begin(), out.end(), 0.0F);
  for (std::size_t row = 0; row < size.rows; ++row)
    for (std::size_t column = 0; column < size.columns; ++column)
      std::copy_n(&in[(row * size.columns + column) * size.channels], size.channels,
                  &out[((row + top) * out_columns + column + left) * out_channels]);
}

void run_depth_to_space(int block_size, const std::vector<int>& in_shape, std::span<const float> in,
                        std::span<float> out) {
  const PictureSize size(in_shape);
  const auto block = static_cast<std::size_t>(block_size);
  const std::size_t run = size.channels / block;  // the channels of one output row of the block
  for (std::size_t row = 0; row < size.rows; ++row)
    for (std::size_t column = 0; column < size.columns; ++column)
      for (std::size_t dy = 0; dy < block; ++dy)
        std::copy_n(&in[(row * size.columns + column) * size.channels + dy * run], run,
                    &out[((row * block + dy) * size.columns + column) * run]);
}

void run_concatenate(const std::vector<std::span<const float>>& parts,
                     const std::vector<std::size_t>& part_runs, std::span<float> out) {
  const std::size_t repetitions = parts[0].size() / part_runs[0];
  auto written = out.begin();
  for (std::size_t k = 0; k < repetitions; ++k)
    for (std::size_t i = 0; i < parts.size(); ++i)
      written = std::copy_n(parts[i].begin() + static_cast<std::ptrdiff_t>(k * part_runs[i]), part_runs[i],
                            written);
}

void run_logistic(std::span<const float> in, std::span<float> out) {
  std::transform(in.begin(), in.end(), out.begin(),
                 [](float x) { return static_cast<float>(logistic(static_cast<double>(x))); });
}

double logistic(double x) {
  return 1.0 / (1.0 + std::exp(-x));
}

}  // namespace posecoach
