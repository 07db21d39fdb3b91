// Which tensors of a network share memory: a buffer is used again as soon as nobody needs its contents.
#pragma once

#include <cstddef>
#include <vector>

#include "core/vision/network_graph.h"

namespace posecoach {

struct BufferPlan {
  std::vector<std::size_t> buffer_of_tensor;  // kNoBuffer for constants and for what is never computed
  std::vector<std::size_t> buffer_elements;   // size of each buffer in floats

  static constexpr std::size_t kNoBuffer = ~std::size_t{0};
};

// Inputs and outputs of the graph keep a buffer of their own; a Reshape is its input; a convolution that adds
// a tensor which nobody needs afterwards writes over that tensor.
BufferPlan plan_buffers(const NetworkGraph& graph);

}  // namespace posecoach
