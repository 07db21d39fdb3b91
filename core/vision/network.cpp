#include "core/vision/network.h"

#include <omp.h>

#include <functional>
#include <numeric>
#include <oneapi/dnnl/dnnl.hpp>

#include "core/base/assert.h"
#include "core/vision/buffer_plan.h"
#include "core/vision/plain_layers.h"

namespace posecoach {
namespace {

using dnnl::memory;

constexpr auto kFloat = memory::data_type::f32;

// OpenMP's number of threads belongs to the calling thread; others keep theirs.
class OneThread {
 public:
  OneThread() : before_(omp_get_max_threads()) { omp_set_num_threads(1); }
  ~OneThread() { omp_set_num_threads(before_); }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  int before_;
};

// The library's order of extents is (batch, channels, rows, columns), whatever the order in memory.
memory::desc picture_description(const std::vector<int>& shape) {
  return {{1, shape[3], shape[1], shape[2]}, kFloat, memory::format_tag::nhwc};
}

dnnl::primitive_attr make_attributes(const Layer& layer) {
  dnnl::post_ops after;
  if (layer.added != kNoTensor) after.append_sum(1.0F);
  if (layer.activation == Activation::Relu6)
    after.append_eltwise(1.0F, dnnl::algorithm::eltwise_bounded_relu, 6.0F, 0.0F);
  dnnl::primitive_attr attributes;
  attributes.set_post_ops(after);
  return attributes;
}

}  // namespace

class Network::Implementation {
 public:
  explicit Implementation(NetworkGraph& graph)
      : shapes_(graph.tensors.size()), plan_(plan_buffers(graph)), engine_(dnnl::engine::kind::cpu, 0) {
    const OneThread one_thread;
    stream_ = dnnl::stream(engine_);
    for (std::size_t i = 0; i < graph.tensors.size(); ++i) shapes_[i] = graph.tensors[i].shape;
    for (const std::size_t elements : plan_.buffer_elements)
      buffers_.emplace_back(memory::desc({static_cast<memory::dim>(elements)}, kFloat, memory::format_tag::a),
                            engine_);
    std::vector<int> filter_uses(graph.tensors.size(), 0);
    for (const Layer& layer : graph.layers)
      if (layer.filter != kNoTensor) ++filter_uses[static_cast<std::size_t>(layer.filter)];
    for (const Layer& layer : graph.layers) {
      add(graph, layer);
      if (layer.filter == kNoTensor) continue;
      const auto filter = static_cast<std::size_t>(layer.filter);
      if (--filter_uses[filter] == 0) graph.tensors[filter].values = {};
    }
    input_ = values(graph.inputs[0]);
    std::fill(input_.begin(), input_.end(), 0.0F);
    for (const int output : graph.outputs) outputs_.push_back(values(output));
    stream_.wait();
  }

  void run() {
    const OneThread one_thread;
    for (const auto& step : steps_) step();
    stream_.wait();
  }

  std::span<float> input() { return input_; }
  std::span<const float> output(std::size_t i) const { return outputs_[i]; }

 private:
  const std::vector<int>& shape(int tensor) const { return shapes_[static_cast<std::size_t>(tensor)]; }

  float* data(int tensor) const {
    const std::size_t buffer = plan_.buffer_of_tensor[static_cast<std::size_t>(tensor)];
    return static_cast<float*>(buffers_[buffer].get_data_handle());
  }

  std::span<float> values(int tensor) const {
    const auto& extents = shape(tensor);
    const auto count = std::accumulate(
        extents.begin(), extents.end(), std::size_t{1},
        [](std::size_t product, int extent) { return product * static_cast<std::size_t>(extent); });
    return {data(tensor), count};
  }

  memory picture(int tensor) const { return {picture_description(shape(tensor)), engine_, data(tensor)}; }

  void add(const NetworkGraph& graph, const Layer& layer) {
    switch (layer.kind) {
      case LayerKind::Convolution:
      case LayerKind::DepthwiseConvolution:
        return add_convolution(graph, layer);
      case LayerKind::Add:
        return add_sum(layer);
      case LayerKind::ResizeBilinear:
        return add_resize(layer);
      case LayerKind::MaxPool:
        return add_pool(layer);
      case LayerKind::Reshape:
        return;  // shares its input's memory
      case LayerKind::Pad:
        steps_.emplace_back([layer, in_shape = shape(layer.inputs[0]), in = values(layer.inputs[0]),
                             out = values(layer.output)] { run_pad(layer, in_shape, in, out); });
        return;
      case LayerKind::DepthToSpace:
        steps_.emplace_back([block = layer.block, in_shape = shape(layer.inputs[0]),
                             in = values(layer.inputs[0]),
                             out = values(layer.output)] { run_depth_to_space(block, in_shape, in, out); });
        return;
      case LayerKind::Logistic:
        steps_.emplace_back(
            [in = values(layer.inputs[0]), out = values(layer.output)] { run_logistic(in, out); });
        return;
      case LayerKind::Concatenate:
        return add_concatenation(layer);
    }
  }

  void add_primitive(dnnl::primitive primitive, std::unordered_map<int, memory> arguments) {
    steps_.emplace_back([this, primitive = std::move(primitive), arguments = std::move(arguments)] {
      primitive.execute(stream_, arguments);
    });
  }

  // Weights as the file has them, copied into the order that the library likes best for this layer.
  memory reordered_weights(const Tensor& filter, bool depthwise, const memory::desc& wanted) {
    const auto extent = [&](std::size_t i) { return static_cast<memory::dim>(filter.shape[i]); };
    const memory::desc stored =
        depthwise
            ? memory::desc({extent(3), 1, 1, extent(1), extent(2)}, kFloat, memory::format_tag::hwigo)
            : memory::desc({extent(0), extent(3), extent(1), extent(2)}, kFloat, memory::format_tag::ohwi);
    memory from(stored, engine_, const_cast<float*>(filter.values.data()));
    memory to(wanted, engine_);
    dnnl::reorder(from, to).execute(stream_, from, to);
    stream_.wait();
    return to;
  }

  memory bias_of(const NetworkGraph& graph, const Layer& layer, memory::dim channels) {
    memory bias({{channels}, kFloat, memory::format_tag::a}, engine_);
    auto* numbers = static_cast<float*>(bias.get_data_handle());
    std::fill_n(numbers, channels, 0.0F);
    if (layer.bias != kNoTensor)
      std::copy(graph.at(layer.bias).values.begin(), graph.at(layer.bias).values.end(), numbers);
    return bias;
  }

  void add_convolution(const NetworkGraph& graph, const Layer& layer) {
    const bool depthwise = layer.kind == LayerKind::DepthwiseConvolution;
    const Tensor& filter = graph.at(layer.filter);
    const memory in = picture(layer.inputs[0]);
    const memory out = picture(layer.output);
    const memory bias = bias_of(graph, layer, shape(layer.output)[3]);
    const auto extent = [&](std::size_t i) { return static_cast<memory::dim>(filter.shape[i]); };
    const memory::dims filter_extents = depthwise ? memory::dims{extent(3), 1, 1, extent(1), extent(2)}
                                                  : memory::dims{extent(0), extent(3), extent(1), extent(2)};
    const Padding& pad = layer.padding;
    const dnnl::convolution_forward::desc wish(
        dnnl::prop_kind::forward_inference, dnnl::algorithm::convolution_direct, in.get_desc(),
        memory::desc(filter_extents, kFloat, memory::format_tag::any), bias.get_desc(), out.get_desc(),
        {layer.stride_y, layer.stride_x}, {pad.top, pad.left}, {pad.bottom, pad.right});
    const dnnl::convolution_forward::primitive_desc chosen(wish, make_attributes(layer), engine_);
    const memory weights = reordered_weights(filter, depthwise, chosen.weights_desc());
    if (layer.added != kNoTensor && data(layer.added) != data(layer.output))
      steps_.emplace_back([from = values(layer.added), to = values(layer.output)] {
        std::copy(from.begin(), from.end(), to.begin());
      });
    add_primitive(
        dnnl::convolution_forward(chosen),
        {{DNNL_ARG_SRC, in}, {DNNL_ARG_WEIGHTS, weights}, {DNNL_ARG_BIAS, bias}, {DNNL_ARG_DST, out}});
  }

  void add_sum(const Layer& layer) {
    const auto flat = [&](int tensor) {
      const auto numbers = values(tensor);
      return memory({{static_cast<memory::dim>(numbers.size())}, kFloat, memory::format_tag::a}, engine_,
                    numbers.data());
    };
    const memory first = flat(layer.inputs[0]);
    const memory second = flat(layer.inputs[1]);
    const memory out = flat(layer.output);
    const dnnl::binary::desc wish(dnnl::algorithm::binary_add, first.get_desc(), second.get_desc(),
                                  out.get_desc());
    const dnnl::binary::primitive_desc chosen(wish, make_attributes(layer), engine_);
    add_primitive(dnnl::binary(chosen),
                  {{DNNL_ARG_SRC_0, first}, {DNNL_ARG_SRC_1, second}, {DNNL_ARG_DST, out}});
  }

  void add_resize(const Layer& layer) {
    const memory in = picture(layer.inputs[0]);
    const memory out = picture(layer.output);
    const dnnl::resampling_forward::desc wish(dnnl::prop_kind::forward_inference,
                                              dnnl::algorithm::resampling_linear, in.get_desc(),
                                              out.get_desc());
    const dnnl::resampling_forward::primitive_desc chosen(wish, engine_);
    add_primitive(dnnl::resampling_forward(chosen), {{DNNL_ARG_SRC, in}, {DNNL_ARG_DST, out}});
  }

  void add_pool(const Layer& layer) {
    const memory in = picture(layer.inputs[0]);
    const memory out = picture(layer.output);
    const dnnl::pooling_forward::desc wish(dnnl::prop_kind::forward_inference, dnnl::algorithm::pooling_max,
                                           in.get_desc(), out.get_desc(), {layer.stride_y, layer.stride_x},
                                           {layer.window_height, layer.window_width}, {0, 0}, {0, 0});
    const dnnl::pooling_forward::primitive_desc chosen(wish, engine_);
    add_primitive(dnnl::pooling_forward(chosen), {{DNNL_ARG_SRC, in}, {DNNL_ARG_DST, out}});
  }

  void add_concatenation(const Layer& layer) {
    std::vector<std::span<const float>> parts;
    std::vector<std::size_t> runs;
    for (const int input : layer.inputs) {
      const auto& extents = shape(input);
      parts.emplace_back(values(input));
      runs.push_back(std::accumulate(
          extents.begin() + layer.axis, extents.end(), std::size_t{1},
          [](std::size_t product, int extent) { return product * static_cast<std::size_t>(extent); }));
    }
    steps_.emplace_back([parts, runs, out = values(layer.output)] { run_concatenate(parts, runs, out); });
  }

  std::vector<std::vector<int>> shapes_;
  BufferPlan plan_;
  dnnl::engine engine_;
  dnnl::stream stream_;
  std::vector<memory> buffers_;
  std::vector<std::function<void()>> steps_;
  std::span<float> input_;
  std::vector<std::span<const float>> outputs_;
};

Network::Network(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
Network::Network(Network&&) noexcept = default;
Network& Network::operator=(Network&&) noexcept = default;
Network::~Network() = default;

Result<Network> Network::make(NetworkGraph graph) {
  if (const auto good = check_graph(graph); !good) return tl::unexpected(good.error());
  POSECOACH_ASSERT(graph.inputs.size() == 1);
  try {
    return Network(std::make_unique<Implementation>(graph));
  } catch (const dnnl::error& error) {
    return fail(ErrorCode::Internal, std::string("the network cannot be built: ") + error.what());
  }
}

std::span<float> Network::input() {
  return implementation_->input();
}

std::span<const float> Network::output(std::size_t i) const {
  return implementation_->output(i);
}

Result<void> Network::run() {
  try {
    implementation_->run();
    return {};
  } catch (const dnnl::error& error) {
    return fail(ErrorCode::Internal, std::string("the network cannot be computed: ") + error.what());
  }
}

}  // namespace posecoach
