#include "core/vision/network_graph.h"

#include <algorithm>

namespace posecoach {
namespace {

using Shape = std::vector<int>;

bool is_index(const NetworkGraph& graph, int tensor) {
  return tensor >= 0 && static_cast<std::size_t>(tensor) < graph.tensors.size();
}

int output_extent(int extent, int before, int after, int window, int stride) {
  const int room = extent + before + after - window;
  return room < 0 || stride < 1 || window < 1 ? 0 : room / stride + 1;
}

bool is_picture(const Shape& shape) {
  return shape.size() == 4 && shape[0] == 1;
}

// The shape that a layer gives; empty when its inputs do not fit together.
Shape convolution_shape(const NetworkGraph& graph, const Layer& layer, const Shape& in) {
  const Shape& filter = graph.at(layer.filter).shape;
  if (!is_picture(in) || filter.size() != 4) return {};
  const bool depthwise = layer.kind == LayerKind::DepthwiseConvolution;
  if (filter[3] != in[3] || (depthwise && filter[0] != 1)) return {};
  const int outputs = depthwise ? in[3] : filter[0];
  if (layer.bias != kNoTensor && graph.at(layer.bias).element_count() != static_cast<std::size_t>(outputs))
    return {};
  const Padding& pad = layer.padding;
  return {1, output_extent(in[1], pad.top, pad.bottom, filter[1], layer.stride_y),
          output_extent(in[2], pad.left, pad.right, filter[2], layer.stride_x), outputs};
}

Shape pool_shape(const Layer& layer, const Shape& in) {
  if (!is_picture(in)) return {};
  const Padding& pad = layer.padding;
  return {1, output_extent(in[1], pad.top, pad.bottom, layer.window_height, layer.stride_y),
          output_extent(in[2], pad.left, pad.right, layer.window_width, layer.stride_x), in[3]};
}

Shape pad_shape(const Layer& layer, const Shape& in) {
  if (!is_picture(in)) return {};
  const Padding& pad = layer.padding;
  return {1, in[1] + pad.top + pad.bottom, in[2] + pad.left + pad.right, in[3] + pad.channels};
}

Shape depth_to_space_shape(const Layer& layer, const Shape& in) {
  const int block = layer.block;
  if (!is_picture(in) || block < 1 || block > 16 || in[3] % (block * block) != 0) return {};
  return {1, in[1] * block, in[2] * block, in[3] / (block * block)};
}

Shape concatenated_shape(const NetworkGraph& graph, const Layer& layer) {
  Shape sum = graph.at(layer.inputs[0]).shape;
  const auto axis = static_cast<std::size_t>(layer.axis);
  if (axis >= sum.size()) return {};
  for (std::size_t i = 1; i < layer.inputs.size(); ++i) {
    Shape other = graph.at(layer.inputs[i]).shape;
    if (other.size() != sum.size()) return {};
    sum[axis] += other[axis];
    other[axis] = sum[axis];
    if (other != sum) return {};
  }
  return sum;
}

Shape layer_shape(const NetworkGraph& graph, const Layer& layer) {
  const Shape& in = graph.at(layer.inputs[0]).shape;
  const Shape& claimed = graph.at(layer.output).shape;
  switch (layer.kind) {
    case LayerKind::Convolution:
    case LayerKind::DepthwiseConvolution: {
      const Shape shape = convolution_shape(graph, layer, in);
      return layer.added == kNoTensor || graph.at(layer.added).shape == shape ? shape : Shape{};
    }
    case LayerKind::Add:
      return graph.at(layer.inputs[1]).shape == in ? in : Shape{};
    case LayerKind::Pad:
      return pad_shape(layer, in);
    case LayerKind::ResizeBilinear:
      return is_picture(in) && is_picture(claimed) && claimed[3] == in[3] ? claimed : Shape{};
    case LayerKind::MaxPool:
      return pool_shape(layer, in);
    case LayerKind::Reshape:
      return graph.at(layer.output).element_count() == graph.at(layer.inputs[0]).element_count() ? claimed
                                                                                                 : Shape{};
    case LayerKind::Concatenate:
      return concatenated_shape(graph, layer);
    case LayerKind::DepthToSpace:
      return depth_to_space_shape(layer, in);
    case LayerKind::Logistic:
      return in;
  }
  return {};
}

bool has_right_number_of_inputs(const Layer& layer) {
  if (layer.kind == LayerKind::Concatenate) return !layer.inputs.empty();
  return layer.inputs.size() == (layer.kind == LayerKind::Add ? 2U : 1U);
}

tl::unexpected<Error> malformed(const NetworkGraph& graph, std::size_t layer, const std::string& what) {
  const int output = graph.layers[layer].output;
  const std::string name = is_index(graph, output) ? " (" + graph.at(output).name + ")" : "";
  return fail(ErrorCode::Malformed, "layer " + std::to_string(layer) + name + " " + what);
}

// Constants of a convolution: a filter that must be there, a bias that may.
bool has_good_weights(const NetworkGraph& graph, const Layer& layer) {
  if (layer.kind != LayerKind::Convolution && layer.kind != LayerKind::DepthwiseConvolution)
    return layer.filter == kNoTensor && layer.bias == kNoTensor && layer.added == kNoTensor;
  if (!is_index(graph, layer.filter) || !graph.at(layer.filter).is_constant()) return false;
  return layer.bias == kNoTensor || (is_index(graph, layer.bias) && graph.at(layer.bias).is_constant());
}

Result<void> check_tensors(const NetworkGraph& graph) {
  constexpr std::size_t kMostElements = std::size_t{1} << 26;
  for (const Tensor& tensor : graph.tensors) {
    const bool positive = std::all_of(tensor.shape.begin(), tensor.shape.end(), [](int n) { return n > 0; });
    if (tensor.is_constant() && tensor.element_count() != tensor.values.size())
      return fail(ErrorCode::Malformed, "tensor " + tensor.name + " has another size than its values");
    if (positive && tensor.element_count() > kMostElements)
      return fail(ErrorCode::Unsupported, "tensor " + tensor.name + " is too large");
  }
  return {};
}

}  // namespace

std::size_t Tensor::element_count() const {
  std::size_t count = 1;
  for (const int extent : shape) {
    if (extent <= 0) return 0;
    // Saturates: shapes come from files.
    if (__builtin_mul_overflow(count, static_cast<std::size_t>(extent), &count)) return ~std::size_t{0};
  }
  return count;
}

std::vector<int> count_uses(const NetworkGraph& graph) {
  std::vector<int> uses(graph.tensors.size(), 0);
  const auto use = [&](int tensor) {
    if (tensor != kNoTensor) ++uses[static_cast<std::size_t>(tensor)];
  };
  for (const Layer& layer : graph.layers) {
    for (const int input : layer.inputs) use(input);
    use(layer.added);
  }
  for (const int output : graph.outputs) use(output);
  return uses;
}

Result<void> check_graph(const NetworkGraph& graph) {
  if (const auto good = check_tensors(graph); !good) return good;
  std::vector<bool> known(graph.tensors.size(), false);
  for (const int input : graph.inputs) {
    if (!is_index(graph, input) || graph.at(input).is_constant() || graph.at(input).element_count() == 0)
      return fail(ErrorCode::Malformed, "the network's input is not a picture");
    known[static_cast<std::size_t>(input)] = true;
  }
  const auto is_known = [&](int tensor) {
    return is_index(graph, tensor) && known[static_cast<std::size_t>(tensor)];
  };
  for (std::size_t i = 0; i < graph.layers.size(); ++i) {
    const Layer& layer = graph.layers[i];
    if (!has_right_number_of_inputs(layer)) return malformed(graph, i, "has a wrong number of inputs");
    if (!std::all_of(layer.inputs.begin(), layer.inputs.end(), is_known) ||
        (layer.added != kNoTensor && !is_known(layer.added)))
      return malformed(graph, i, "reads what is not computed before it");
    if (!is_index(graph, layer.output) || is_known(layer.output) || graph.at(layer.output).is_constant())
      return malformed(graph, i, "writes what it must not");
    if (!has_good_weights(graph, layer)) return malformed(graph, i, "has wrong weights");
    if (graph.at(layer.output).element_count() == 0 ||
        layer_shape(graph, layer) != graph.at(layer.output).shape)
      return malformed(graph, i, "has an output of a wrong shape");
    known[static_cast<std::size_t>(layer.output)] = true;
  }
  for (const int output : graph.outputs)
    if (!is_known(output)) return fail(ErrorCode::Malformed, "an output of the network is never computed");
  return {};
}

}  // namespace posecoach
