// A network as plain values: what is computed from what, with which weights. Activations are 32-bit floats in
// the order (batch 1, row, column, channel); other shapes are flat views of the same order.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"

namespace posecoach {

enum class LayerKind {
  Convolution,           // filter (outputs, rows, columns, inputs)
  DepthwiseConvolution,  // filter (1, rows, columns, channels)
  Add,
  Pad,
  ResizeBilinear,  // pixel centres at half, edges repeated
  MaxPool,
  Reshape,
  Concatenate,
  DepthToSpace,  // channel (dy * block + dx) * outputs + c goes to pixel (dx, dy) of its block
  Logistic
};

enum class Activation { None, Relu6 };

// Zeros around a picture, and zero channels behind its own.
struct Padding {
  int left = 0;
  int right = 0;
  int top = 0;
  int bottom = 0;
  int channels = 0;

  bool operator==(const Padding&) const = default;
};

inline constexpr int kNoTensor = -1;

// Tensors are named by their place in NetworkGraph::tensors.
struct Layer {
  LayerKind kind = LayerKind::Add;
  std::vector<int> inputs;
  int output = kNoTensor;
  int filter = kNoTensor;  // convolutions
  int bias = kNoTensor;
  Padding padding = {};
  int stride_x = 1;
  int stride_y = 1;
  int window_width = 1;  // pooling
  int window_height = 1;
  int block = 1;  // DepthToSpace
  int axis = 0;   // Concatenate
  Activation activation = Activation::None;
  // A convolution may add another tensor to its result before the activation.
  int added = kNoTensor;
};

struct Tensor {
  std::string name;
  std::vector<int> shape;
  std::vector<float> values;  // of a constant; empty for what is computed

  bool is_constant() const { return !values.empty(); }
  std::size_t element_count() const;
};

struct NetworkGraph {
  std::vector<Tensor> tensors;
  std::vector<int> inputs;
  std::vector<int> outputs;
  std::vector<Layer> layers;  // in an order in which they can be computed

  const Tensor& at(int tensor) const { return tensors[static_cast<std::size_t>(tensor)]; }
};

// Whether every layer reads what exists, writes what nobody else writes, and gives the shape that its output
// claims. Error: Malformed, naming layer and tensor.
Result<void> check_graph(const NetworkGraph& graph);

// The same results for the named outputs (in that order) with less work: layers that nobody needs are gone,
// spatial paddings are part of the convolutions behind them, residual sums part of the convolutions before
// them. `graph` must have passed check_graph. Error: NotFound for an output that is not there.
Result<NetworkGraph> simplified_graph(NetworkGraph graph, const std::vector<std::string>& outputs);

// How often each tensor is read, as a layer's input, addend, or the graph's output.
std::vector<int> count_uses(const NetworkGraph& graph);

}  // namespace posecoach
