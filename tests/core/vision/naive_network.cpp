#include "tests/core/vision/naive_network.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace posecoach {
namespace {

using Values = std::vector<float>;

struct Picture {
  const Tensor& tensor;
  const Values& values;
  int rows() const { return tensor.shape[1]; }
  int columns() const { return tensor.shape[2]; }
  int channels() const { return tensor.shape[3]; }
  double at(int row, int column, int channel) const {
    if (row < 0 || column < 0 || row >= rows() || column >= columns() || channel >= channels()) return 0;
    return static_cast<double>(
        values[static_cast<std::size_t>((row * columns() + column) * channels() + channel)]);
  }
};

using PixelFunction = std::function<double(int row, int column, int channel)>;

Values fill(const std::vector<int>& shape, const PixelFunction& pixel) {
  Values out;
  for (int row = 0; row < shape[1]; ++row)
    for (int column = 0; column < shape[2]; ++column)
      for (int channel = 0; channel < shape[3]; ++channel)
        out.push_back(static_cast<float>(pixel(row, column, channel)));
  return out;
}

double activate(Activation activation, double x) {
  return activation == Activation::Relu6 ? std::clamp(x, 0.0, 6.0) : x;
}

double convolve(const NetworkGraph& graph, const Layer& layer, const Picture& in, int row, int column,
                int channel) {
  const Tensor& filter = graph.at(layer.filter);
  const bool depthwise = layer.kind == LayerKind::DepthwiseConvolution;
  const int height = filter.shape[1];
  const int width = filter.shape[2];
  const int depth = filter.shape[3];
  double sum = layer.bias == kNoTensor
                   ? 0.0
                   : static_cast<double>(graph.at(layer.bias).values[static_cast<std::size_t>(channel)]);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = depthwise ? channel : 0; c < (depthwise ? channel + 1 : depth); ++c) {
        const int o = depthwise ? 0 : channel;
        const auto weight = static_cast<std::size_t>(((o * height + y) * width + x) * depth + c);
        sum += static_cast<double>(filter.values[weight]) *
               in.at(row * layer.stride_y + y - layer.padding.top,
                     column * layer.stride_x + x - layer.padding.left, c);
      }
  return sum;
}

double resize(const Picture& in, const std::vector<int>& out_shape, int row, int column, int channel) {
  const auto place = [](int index, int from, int to) {
    return std::clamp((index + 0.5) * from / to - 0.5, 0.0, static_cast<double>(from - 1));
  };
  const double y = place(row, in.rows(), out_shape[1]);
  const double x = place(column, in.columns(), out_shape[2]);
  const int y0 = static_cast<int>(y);
  const int x0 = static_cast<int>(x);
  const int y1 = std::min(y0 + 1, in.rows() - 1);
  const int x1 = std::min(x0 + 1, in.columns() - 1);
  const double fy = y - y0;
  const double fx = x - x0;
  return (1 - fy) * ((1 - fx) * in.at(y0, x0, channel) + fx * in.at(y0, x1, channel)) +
         fy * ((1 - fx) * in.at(y1, x0, channel) + fx * in.at(y1, x1, channel));
}

Values run_layer(const NetworkGraph& graph, const Layer& layer, const std::vector<Values>& known) {
  const auto values = [&](int tensor) -> const Values& { return known[static_cast<std::size_t>(tensor)]; };
  const Values& first = values(layer.inputs[0]);
  const Picture in{graph.at(layer.inputs[0]), first};
  const std::vector<int>& shape = graph.at(layer.output).shape;
  switch (layer.kind) {
    case LayerKind::Convolution:
    case LayerKind::DepthwiseConvolution:
      return fill(shape, [&](int row, int column, int channel) {
        double sum = convolve(graph, layer, in, row, column, channel);
        if (layer.added != kNoTensor)
          sum += Picture{graph.at(layer.added), values(layer.added)}.at(row, column, channel);
        return activate(layer.activation, sum);
      });
    case LayerKind::Pad:
      return fill(shape, [&](int row, int column, int channel) {
        return in.at(row - layer.padding.top, column - layer.padding.left, channel);
      });
    case LayerKind::ResizeBilinear:
      return fill(shape,
                  [&](int row, int column, int channel) { return resize(in, shape, row, column, channel); });
    case LayerKind::MaxPool:
      return fill(shape, [&](int row, int column, int channel) {
        double best = -1e30;
        for (int y = 0; y < layer.window_height; ++y)
          for (int x = 0; x < layer.window_width; ++x)
            best = std::max(best, in.at(row * layer.stride_y + y, column * layer.stride_x + x, channel));
        return best;
      });
    case LayerKind::DepthToSpace:
      return fill(shape, [&](int row, int column, int channel) {
        const int part = (row % layer.block) * layer.block + column % layer.block;
        return in.at(row / layer.block, column / layer.block, part * shape[3] + channel);
      });
    case LayerKind::Add: {
      Values out = first;
      for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = static_cast<float>(activate(
            layer.activation, static_cast<double>(out[i]) + static_cast<double>(values(layer.inputs[1])[i])));
      return out;
    }
    case LayerKind::Reshape:
      return first;
    case LayerKind::Concatenate: {  // only of flat lists behind one another
      Values out;
      for (const int input : layer.inputs) out.insert(out.end(), values(input).begin(), values(input).end());
      return out;
    }
    case LayerKind::Logistic: {
      Values out = first;
      for (float& value : out) value = static_cast<float>(1 / (1 + std::exp(-static_cast<double>(value))));
      return out;
    }
  }
  return {};
}

class GraphMaker {
 public:
  explicit GraphMaker(std::mt19937& random) : random_(random) {}

  NetworkGraph make() {
    graph_.inputs = {add_tensor({1, pick(4, 9), pick(4, 9), pick(1, 5)})};
    pictures_ = graph_.inputs;
    for (int i = 0; i < 14; ++i) add_layer();
    // Flat heads behind one another, as the detector has them.
    std::vector<int> flat;
    int sum = 0;
    for (int i = 0; i < 2; ++i) {
      const int from = any_picture();
      const int count = static_cast<int>(graph_.at(from).element_count());
      flat.push_back(append({.kind = LayerKind::Reshape, .inputs = {from}}, {1, count}));
      sum += count;
    }
    const int joined = append({.kind = LayerKind::Concatenate, .inputs = flat, .axis = 1}, {1, sum});
    add_output(append({.kind = LayerKind::Logistic, .inputs = {joined}}, {1, sum}));
    add_output(pictures_.back());
    if (const int extra = any_picture(); extra != pictures_.back() && extra != graph_.inputs[0])
      add_output(extra);
    return std::move(graph_);
  }

 private:
  int pick(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  bool chance() { return pick(0, 1) == 1; }
  int any_picture() {
    // Mostly recent ones, so that networks become deep.
    const int last = static_cast<int>(pictures_.size()) - 1;
    return pictures_[static_cast<std::size_t>(pick(std::max(0, last - 3), last))];
  }
  int add_tensor(std::vector<int> shape) {
    graph_.tensors.push_back({"t" + std::to_string(graph_.tensors.size()), std::move(shape), {}});
    return static_cast<int>(graph_.tensors.size()) - 1;
  }
  int add_constant(std::vector<int> shape) {
    const int tensor = add_tensor(std::move(shape));
    Tensor& made = graph_.tensors.back();
    std::uniform_real_distribution<float> number(-0.6F, 0.6F);
    made.values.resize(made.element_count());
    for (float& value : made.values) value = number(random_);
    return tensor;
  }
  int append(Layer layer, std::vector<int> shape) {
    layer.output = add_tensor(std::move(shape));
    graph_.layers.push_back(layer);
    return layer.output;
  }
  void add_output(int tensor) {
    graph_.tensors[static_cast<std::size_t>(tensor)].name = "out" + std::to_string(graph_.outputs.size());
    graph_.outputs.push_back(tensor);
  }

  void add_convolution(int from, bool keeps_size) {
    const std::vector<int> in = graph_.at(from).shape;
    Layer layer;
    layer.kind = chance() ? LayerKind::Convolution : LayerKind::DepthwiseConvolution;
    layer.inputs = {from};
    const bool depthwise = layer.kind == LayerKind::DepthwiseConvolution;
    const int reach = pick(0, 1);
    const int outputs = depthwise || keeps_size ? in[3] : pick(1, 9);
    layer.filter = add_constant({depthwise ? 1 : outputs, 2 * reach + 1, 2 * reach + 1, in[3]});
    if (chance()) layer.bias = add_constant({outputs});
    layer.padding = {reach, reach, reach, reach, 0};
    const int stride = keeps_size || in[1] < 6 || in[2] < 6 ? 1 : pick(1, 2);
    layer.stride_x = layer.stride_y = stride;
    if (!keeps_size && chance()) layer.activation = Activation::Relu6;
    pictures_.push_back(append(layer, {1, (in[1] - 1) / stride + 1, (in[2] - 1) / stride + 1, outputs}));
  }

  void add_residual(int from) {
    add_convolution(from, true);
    const int branch = pictures_.back();
    Layer sum;
    sum.kind = LayerKind::Add;
    sum.inputs = chance() ? std::vector{from, branch} : std::vector{branch, from};
    if (chance()) sum.activation = Activation::Relu6;
    pictures_.push_back(append(sum, graph_.at(from).shape));
  }

  void add_layer() {
    const int from = any_picture();
    const std::vector<int> in = graph_.at(from).shape;
    switch (pick(0, 7)) {
      case 0:
      case 1:
        return add_residual(from);
      case 2: {
        const Padding pad{pick(0, 2), pick(0, 2), pick(0, 2), pick(0, 2), chance() ? 0 : pick(1, 3)};
        if (in[1] > 20 || in[2] > 20) return add_convolution(from, false);
        pictures_.push_back(
            append({.kind = LayerKind::Pad, .inputs = {from}, .padding = pad},
                   {1, in[1] + pad.top + pad.bottom, in[2] + pad.left + pad.right, in[3] + pad.channels}));
        return add_convolution(pictures_.back(), false);
      }
      case 3:
        if (in[1] > 20 || in[2] > 20) return add_convolution(from, false);
        pictures_.push_back(
            append({.kind = LayerKind::ResizeBilinear, .inputs = {from}}, {1, 2 * in[1], 2 * in[2], in[3]}));
        return;
      case 4: {
        if (in[1] < 4 || in[2] < 4) return add_convolution(from, false);
        const Layer pool{.kind = LayerKind::MaxPool,
                         .inputs = {from},
                         .stride_x = 2,
                         .stride_y = 2,
                         .window_width = 2,
                         .window_height = 2};
        pictures_.push_back(append(pool, {1, in[1] / 2, in[2] / 2, in[3]}));
        return;
      }
      case 5:
        if (in[3] % 4 != 0 || in[1] > 20) return add_convolution(from, false);
        pictures_.push_back(append({.kind = LayerKind::DepthToSpace, .inputs = {from}, .block = 2},
                                   {1, 2 * in[1], 2 * in[2], in[3] / 4}));
        return;
      default:
        return add_convolution(from, false);
    }
  }

  std::mt19937& random_;
  NetworkGraph graph_;
  std::vector<int> pictures_;
};

}  // namespace

std::vector<std::vector<float>> run_naively(const NetworkGraph& graph, const std::vector<float>& input) {
  std::vector<Values> known(graph.tensors.size());
  known[static_cast<std::size_t>(graph.inputs[0])] = input;
  for (const Layer& layer : graph.layers)
    known[static_cast<std::size_t>(layer.output)] = run_layer(graph, layer, known);
  std::vector<Values> outputs;
  for (const int output : graph.outputs) outputs.push_back(known[static_cast<std::size_t>(output)]);
  return outputs;
}

NetworkGraph make_random_graph(std::mt19937& random) {
  return GraphMaker(random).make();
}

}  // namespace posecoach
