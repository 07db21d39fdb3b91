#include "tests/core/vision/tflite_builder.h"

#include <cmath>
#include <cstring>

namespace posecoach {
namespace {

class FlatWriter {
 public:
  std::string write(const FlatNode& root, const std::string& identifier) {
    bytes_ = std::string(4, '\0') + identifier;
    point(0, add(root));
    return std::move(bytes_);
  }

 private:
  void point(std::size_t from, std::size_t to) {
    const auto offset = static_cast<std::uint32_t>(to - from);
    std::memcpy(&bytes_[from], &offset, sizeof offset);
  }

  std::size_t add(const FlatNode& node) {
    switch (node.kind) {
      case FlatNode::Kind::Raw: {
        const std::size_t at = bytes_.size();
        bytes_ += raw_bytes(node.raw_count) + node.raw;
        return at;
      }
      case FlatNode::Kind::Tables: {
        const std::size_t at = bytes_.size();
        bytes_ += raw_bytes(static_cast<std::uint32_t>(node.elements.size()));
        const std::size_t first = bytes_.size();
        bytes_.append(4 * node.elements.size(), '\0');
        for (std::size_t i = 0; i < node.elements.size(); ++i) point(first + 4 * i, add(node.elements[i]));
        return at;
      }
      case FlatNode::Kind::Table:
        return add_table(node);
    }
    return 0;
  }

  std::size_t add_table(const FlatNode& node) {
    int slots = 0;
    for (const auto& [slot, bytes] : node.numbers) slots = std::max(slots, slot + 1);
    for (const auto& [slot, child] : node.children) slots = std::max(slots, slot + 1);
    std::vector<std::uint16_t> offsets(static_cast<std::size_t>(slots), 0);
    std::string body(4, '\0');
    for (const auto& [slot, bytes] : node.numbers) {
      offsets[static_cast<std::size_t>(slot)] = static_cast<std::uint16_t>(body.size());
      body += bytes;
    }
    for (const auto& [slot, child] : node.children) {
      offsets[static_cast<std::size_t>(slot)] = static_cast<std::uint16_t>(body.size());
      body.append(4, '\0');
    }
    const std::size_t list = bytes_.size();
    bytes_ += raw_bytes(static_cast<std::uint16_t>(4 + 2 * offsets.size()));
    bytes_ += raw_bytes(static_cast<std::uint16_t>(body.size()));
    for (const std::uint16_t offset : offsets) bytes_ += raw_bytes(offset);
    const std::size_t at = bytes_.size();
    const auto back = static_cast<std::int32_t>(at - list);
    std::memcpy(body.data(), &back, sizeof back);
    bytes_ += body;
    for (const auto& [slot, child] : node.children)
      point(at + offsets[static_cast<std::size_t>(slot)], add(child));
    return at;
  }

  std::string bytes_;
};

// Exact for what the tests use: multiples of 1/64 below 32.
std::uint16_t half_from_float(float value) {
  if (value == 0) return 0;
  int exponent = 0;
  const float fraction = std::frexp(std::abs(value), &exponent);  // in [0.5, 1)
  const auto mantissa = static_cast<std::uint16_t>(std::lround((fraction * 2 - 1) * 1024));
  return static_cast<std::uint16_t>((value < 0 ? 0x8000 : 0) | ((exponent + 14) << 10) | mantissa);
}

class ModelMaker {
 public:
  ModelMaker(const NetworkGraph& graph, WeightStorage storage) : graph_(graph), storage_(storage) {}

  FlatNode make() {
    buffers_.emplace_back();  // number 0 means: no constant
    for (const Tensor& tensor : graph_.tensors) add_tensor(tensor);
    for (const Layer& layer : graph_.layers) add_layer(layer);
    FlatNode subgraph;
    subgraph.children = {{0, flat_tables(tensors_)},
                         {1, flat_numbers(graph_.inputs)},
                         {2, flat_numbers(graph_.outputs)},
                         {3, flat_tables(operators_)}};
    FlatNode model;
    model.numbers = {{0, raw_bytes(std::uint32_t{3})}};
    model.children = {{1, flat_tables(codes_)}, {2, flat_tables({subgraph})}, {4, flat_tables(buffers_)}};
    return model;
  }

 private:
  int add_raw_tensor(const std::vector<int>& shape, std::int8_t type, const std::string& name,
                     const FlatNode* data) {
    FlatNode tensor;
    tensor.numbers = {{1, raw_bytes(type)}};
    tensor.children = {{0, flat_numbers(shape)}, {3, flat_text(name)}};
    if (data != nullptr) {
      tensor.numbers[2] = raw_bytes(static_cast<std::uint32_t>(buffers_.size()));
      FlatNode buffer;
      buffer.children = {{0, *data}};
      buffers_.push_back(buffer);
    }
    tensors_.push_back(tensor);
    return static_cast<int>(tensors_.size()) - 1;
  }

  static FlatNode as_bytes(const FlatNode& numbers) {
    FlatNode bytes = numbers;
    bytes.raw_count = static_cast<std::uint32_t>(bytes.raw.size());
    return bytes;
  }

  // The graph's tensors keep their numbers; packed copies come behind them.
  void add_tensor(const Tensor& tensor) {
    const bool packed = tensor.is_constant() && storage_ != WeightStorage::Float32;
    const FlatNode data = as_bytes(flat_numbers(tensor.values));
    add_raw_tensor(tensor.shape, 0, tensor.name, tensor.is_constant() && !packed ? &data : nullptr);
    if (packed) waiting_.push_back(static_cast<int>(tensors_.size()) - 1);
    if (tensors_.size() == graph_.tensors.size())
      for (const int number : waiting_) add_packed(number);
  }

  void add_packed(int number) {
    const Tensor& tensor = graph_.at(number);
    const bool sparse = storage_ == WeightStorage::SparseFloat16 && tensor.shape.size() == 4;
    std::vector<std::uint16_t> halves;
    std::vector<std::uint16_t> segments = {0};
    std::vector<std::uint8_t> columns;
    const auto row = static_cast<std::size_t>(tensor.shape.back());
    for (std::size_t i = 0; i < tensor.values.size(); ++i) {
      if (!sparse || tensor.values[i] != 0) {
        halves.push_back(half_from_float(tensor.values[i]));
        columns.push_back(static_cast<std::uint8_t>(i % row));
      }
      if (i % row == row - 1) segments.push_back(static_cast<std::uint16_t>(halves.size()));
    }
    const FlatNode data = as_bytes(flat_numbers(halves));
    int packed = add_raw_tensor(tensor.shape, 1, tensor.name + "_packed", &data);
    if (sparse) {
      tensors_.back().children[6] = sparsity(tensor.shape, segments, columns);
      const int dense = add_raw_tensor(tensor.shape, 1, tensor.name + "_dense", nullptr);
      add_operator(124, {packed}, dense, {});
      packed = dense;
    }
    add_operator(6, {packed}, number, {});
  }

  static FlatNode sparsity(const std::vector<int>& shape, const std::vector<std::uint16_t>& segments,
                           const std::vector<std::uint8_t>& columns) {
    std::vector<FlatNode> dimensions(shape.size());
    std::vector<std::int32_t> order;
    for (std::size_t i = 0; i < shape.size(); ++i) {
      dimensions[i].numbers = {{0, raw_bytes(std::int8_t{0})}, {1, raw_bytes(std::int32_t{shape[i]})}};
      order.push_back(static_cast<std::int32_t>(i));
    }
    FlatNode segment_list;
    segment_list.children = {{0, flat_numbers(segments)}};
    FlatNode column_list;
    column_list.children = {{0, flat_numbers(columns)}};
    dimensions.back().numbers = {
        {0, raw_bytes(std::int8_t{1})}, {2, raw_bytes(std::uint8_t{2})}, {4, raw_bytes(std::uint8_t{3})}};
    dimensions.back().children = {{3, segment_list}, {5, column_list}};
    FlatNode node;
    node.children = {{0, flat_numbers(order)}, {2, flat_tables(dimensions)}};
    return node;
  }

  void add_operator(int code, const std::vector<int>& inputs, int output, const FlatNode& options) {
    FlatNode operation;
    operation.numbers = {{0, raw_bytes(static_cast<std::uint32_t>(codes_.size()))}};
    operation.children = {{1, flat_numbers(inputs)}, {2, flat_numbers(std::vector{output})}, {4, options}};
    operators_.push_back(operation);
    FlatNode stored;
    stored.numbers = {{0, raw_bytes(static_cast<std::int8_t>(std::min(code, 127)))}, {3, raw_bytes(code)}};
    codes_.push_back(stored);
  }

  static FlatNode numbers(std::map<int, std::string> values) {
    FlatNode node;
    node.numbers = std::move(values);
    return node;
  }

  int add_pad(int from, const Padding& pad, std::optional<int> to) {
    std::vector<int> shape = graph_.at(from).shape;
    shape[1] += pad.top + pad.bottom;
    shape[2] += pad.left + pad.right;
    shape[3] += pad.channels;
    const FlatNode data = as_bytes(flat_numbers(
        std::vector<std::int32_t>{0, 0, pad.top, pad.bottom, pad.left, pad.right, 0, pad.channels}));
    const int amounts = add_raw_tensor({4, 2}, 2, "pads", &data);
    const int padded = to ? *to : add_raw_tensor(shape, 0, "padded", nullptr);
    add_operator(34, {from, amounts}, padded, {});
    return padded;
  }

  void add_layer(const Layer& layer) {
    const std::string activation =
        raw_bytes(static_cast<std::int8_t>(layer.activation == Activation::Relu6 ? 3 : 0));
    const std::string valid = raw_bytes(std::int8_t{1});
    const std::string stride_x = raw_bytes(std::int32_t{layer.stride_x});
    const std::string stride_y = raw_bytes(std::int32_t{layer.stride_y});
    switch (layer.kind) {
      case LayerKind::Convolution:
      case LayerKind::DepthwiseConvolution: {
        std::vector<int> inputs = {layer.inputs[0], layer.filter};
        if (layer.padding != Padding{}) inputs[0] = add_pad(layer.inputs[0], layer.padding, std::nullopt);
        if (layer.bias != kNoTensor) inputs.push_back(layer.bias);
        if (layer.kind == LayerKind::Convolution)
          return add_operator(3, inputs, layer.output,
                              numbers({{0, valid}, {1, stride_x}, {2, stride_y}, {3, activation}}));
        return add_operator(4, inputs, layer.output,
                            numbers({{0, valid},
                                     {1, stride_x},
                                     {2, stride_y},
                                     {3, raw_bytes(std::int32_t{1})},
                                     {4, activation}}));
      }
      case LayerKind::Add:
        return add_operator(0, layer.inputs, layer.output, numbers({{0, activation}}));
      case LayerKind::Pad:
        add_pad(layer.inputs[0], layer.padding, layer.output);
        return;
      case LayerKind::ResizeBilinear:
        return add_operator(23, layer.inputs, layer.output,
                            numbers({{2, raw_bytes(std::uint8_t{0})}, {3, raw_bytes(std::uint8_t{1})}}));
      case LayerKind::MaxPool:
        return add_operator(17, layer.inputs, layer.output,
                            numbers({{0, valid},
                                     {1, stride_x},
                                     {2, stride_y},
                                     {3, raw_bytes(std::int32_t{layer.window_width})},
                                     {4, raw_bytes(std::int32_t{layer.window_height})}}));
      case LayerKind::Reshape:
        return add_operator(22, layer.inputs, layer.output, {});
      case LayerKind::Concatenate:
        return add_operator(2, layer.inputs, layer.output,
                            numbers({{0, raw_bytes(std::int32_t{layer.axis})}}));
      case LayerKind::DepthToSpace:
        return add_operator(5, layer.inputs, layer.output,
                            numbers({{0, raw_bytes(std::int32_t{layer.block})}}));
      case LayerKind::Logistic:
        return add_operator(14, layer.inputs, layer.output, {});
    }
  }

  const NetworkGraph& graph_;
  WeightStorage storage_;
  std::vector<FlatNode> tensors_;
  std::vector<FlatNode> buffers_;
  std::vector<FlatNode> codes_;
  std::vector<FlatNode> operators_;
  std::vector<int> waiting_;
};

}  // namespace

FlatNode flat_text(const std::string& text) {
  FlatNode node;
  node.kind = FlatNode::Kind::Raw;
  node.raw = text;
  node.raw_count = static_cast<std::uint32_t>(text.size());
  return node;
}

FlatNode flat_tables(std::vector<FlatNode> elements) {
  FlatNode node;
  node.kind = FlatNode::Kind::Tables;
  node.elements = std::move(elements);
  return node;
}

std::string flatbuffer_bytes(const FlatNode& root, const std::string& identifier) {
  return FlatWriter().write(root, identifier);
}

FlatNode tflite_model(const NetworkGraph& graph, WeightStorage storage) {
  return ModelMaker(graph, storage).make();
}

std::string tflite_bytes(const NetworkGraph& graph, WeightStorage storage) {
  return flatbuffer_bytes(tflite_model(graph, storage), "TFL3");
}

}  // namespace posecoach
