#include "core/vision/tflite_reader.h"

#include <algorithm>

#include "core/vision/flatbuffer.h"
#include "core/vision/tflite_weights.h"

namespace posecoach {
namespace {

// Far above what the pose networks need, far below what would hurt.
constexpr std::size_t kMostTensors = 20'000;
constexpr std::size_t kMostInputs = 16;
constexpr std::size_t kMostDimensions = 8;
constexpr std::size_t kMostWeights = std::size_t{1} << 24;
constexpr int kLargestStep = 1024;

// Numbers that the file format gives to operations.
enum class Code {
  Add = 0,
  Concatenation = 2,
  Conv2d = 3,
  DepthwiseConv2d = 4,
  DepthToSpace = 5,
  Dequantize = 6,
  Logistic = 14,
  MaxPool2d = 17,
  Reshape = 22,
  ResizeBilinear = 23,
  Pad = 34,
  Densify = 124
};

class Reader {
 public:
  Reader(std::string_view bytes, const std::string& name) : file_(bytes), name_(name) {}

  Result<NetworkGraph> read() {
    if (file_.identifier() != "TFL3") return malformed("is not a TensorFlow Lite network");
    const FlatTable model = file_.root();
    const FlatVector subgraphs = model.tables(2);
    if (!file_.bad_byte() && subgraphs.size() != 1)
      return unsupported("has " + std::to_string(subgraphs.size()) + " subgraphs instead of one");
    const FlatTable subgraph = subgraphs.table(0);
    read_codes(model.tables(1));
    if (auto done = read_tensors(subgraph.tables(0), model.tables(4)); !done) return forward(done);
    const FlatVector operators = subgraph.tables(3);
    for (std::size_t i = 0; i < operators.size(); ++i) {
      layer_ = i;
      if (auto done = read_operator(operators.table(i)); !done) return forward(done);
    }
    graph_.inputs = indices(subgraph.numbers<std::int32_t>(1));
    graph_.outputs = indices(subgraph.numbers<std::int32_t>(2));
    if (file_.bad_byte())
      return malformed("is damaged: it points outside itself at byte " + std::to_string(*file_.bad_byte()));
    if (graph_.inputs.size() != 1 || graph_.outputs.empty() || graph_.layers.empty())
      return malformed("is damaged: it has no input, layers or outputs");
    if (const auto good = check_graph(graph_); !good)
      return fail(good.error().code, name_ + ": " + good.error().message);
    return std::move(graph_);
  }

 private:
  tl::unexpected<Error> malformed(const std::string& what) const {
    return fail(ErrorCode::Malformed, name_ + " " + what);
  }
  tl::unexpected<Error> unsupported(const std::string& what) const {
    return fail(ErrorCode::Unsupported, name_ + " " + what);
  }
  // A file that leaves itself is damaged, whatever the nonsense read there looks like.
  tl::unexpected<Error> forward(const Result<void>& failed) const {
    if (file_.bad_byte())
      return malformed("is damaged: it points outside itself at byte " + std::to_string(*file_.bad_byte()));
    return tl::unexpected(failed.error());
  }
  tl::unexpected<Error> bad_layer(const std::string& what) const {
    return unsupported("needs what is not supported: operation " + std::to_string(layer_) + " " + what);
  }

  // Names end up in messages.
  static std::string printable(std::string_view text) {
    std::string out(text.substr(0, 80));
    std::replace_if(
        out.begin(), out.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return out;
  }

  static std::vector<int> indices(const FlatVector& numbers) {
    std::vector<int> out;
    for (std::size_t i = 0; i < std::min(numbers.size(), kMostInputs); ++i)
      out.push_back(numbers.number<std::int32_t>(i));
    return out;
  }

  void read_codes(const FlatVector& codes) {
    for (std::size_t i = 0; i < std::min(codes.size(), kMostTensors); ++i) {
      const FlatTable code = codes.table(i);
      // Old writers know only the first field, new ones put 127 there for high codes.
      codes_.push_back(std::max<int>(code.number<std::int8_t>(0), code.number<std::int32_t>(3)));
    }
  }

  Result<void> read_tensors(const FlatVector& tensors, const FlatVector& buffers) {
    if (tensors.size() > kMostTensors) return unsupported("has too many tensors");
    std::size_t weights = 0;
    for (std::size_t i = 0; i < tensors.size(); ++i) {
      const FlatTable stored = tensors.table(i);
      Tensor tensor;
      tensor.name = printable(stored.text(3));
      const FlatVector shape = stored.numbers<std::int32_t>(0);
      if (shape.size() > kMostDimensions) return unsupported("has a tensor of too many dimensions");
      for (std::size_t k = 0; k < shape.size(); ++k) tensor.shape.push_back(shape.number<std::int32_t>(k));
      const std::string_view data =
          buffers.table(stored.number<std::uint32_t>(2)).numbers<std::uint8_t>(0).bytes();
      const auto type = static_cast<TfliteType>(stored.number<std::int8_t>(1));
      if (!data.empty() && type == TfliteType::Int32) {
        integers_.push_back(data);
      } else {
        integers_.emplace_back();
        // Sparse weights may all be zero, and then none is stored.
        if (!data.empty() || stored.table(6)) {
          weights += std::min(tensor.element_count(), kMostWeights + 1);
          if (weights > kMostWeights) return unsupported("has too many weights");
          auto values = tflite_floats(stored, data, tensor.shape, tensor.element_count());
          if (!values)
            return fail(values.error().code,
                        name_ + ": tensor " + tensor.name + " " + values.error().message);
          tensor.values = std::move(*values);
        }
      }
      graph_.tensors.push_back(std::move(tensor));
    }
    return {};
  }

  bool is_tensor(int index) const {
    return index >= 0 && static_cast<std::size_t>(index) < graph_.tensors.size();
  }
  Tensor& tensor(int index) { return graph_.tensors[static_cast<std::size_t>(index)]; }

  Result<void> read_operator(const FlatTable& stored) {
    const std::vector<int> inputs = indices(stored.numbers<std::int32_t>(1));
    const std::vector<int> outputs = indices(stored.numbers<std::int32_t>(2));
    const auto code_index = stored.number<std::uint32_t>(0);
    if (code_index >= codes_.size() || inputs.empty() || outputs.size() != 1 || !is_tensor(outputs[0]) ||
        !is_tensor(inputs[0]))
      return malformed("is damaged: operation " + std::to_string(layer_) + " names what is not there");
    const FlatTable options = stored.table(4);
    Layer layer;
    layer.output = outputs[0];
    layer.inputs = {inputs[0]};
    switch (static_cast<Code>(codes_[code_index])) {
      case Code::Dequantize:
      case Code::Densify:
        return read_constant(inputs[0], outputs[0]);
      case Code::Conv2d:
        return read_convolution(layer, LayerKind::Convolution, inputs, options);
      case Code::DepthwiseConv2d:
        return read_convolution(layer, LayerKind::DepthwiseConvolution, inputs, options);
      case Code::MaxPool2d:
        return read_pool(layer, options);
      case Code::Add:
        layer.kind = LayerKind::Add;
        layer.inputs = inputs;
        return finish(layer, options.number<std::int8_t>(0));
      case Code::Concatenation:
        layer.kind = LayerKind::Concatenate;
        layer.inputs = inputs;
        layer.axis = options.number<std::int32_t>(0);
        if (layer.axis < 0) layer.axis += static_cast<int>(tensor(inputs[0]).shape.size());
        return finish(layer, options.number<std::int8_t>(1));
      case Code::DepthToSpace:
        layer.kind = LayerKind::DepthToSpace;
        layer.block = options.number<std::int32_t>(0);
        return finish(layer, 0);
      case Code::Logistic:
        layer.kind = LayerKind::Logistic;
        return finish(layer, 0);
      case Code::Reshape:
        layer.kind = LayerKind::Reshape;
        return finish(layer, 0);
      case Code::ResizeBilinear:
        layer.kind = LayerKind::ResizeBilinear;
        if (options.number<std::uint8_t>(2) != 0 || options.number<std::uint8_t>(3) == 0)
          return bad_layer("resizes by another rule than half-pixel centres");
        return finish(layer, 0);
      case Code::Pad:
        return read_pad(layer, inputs);
    }
    return bad_layer("is of kind " + std::to_string(codes_[code_index]));
  }

  Result<void> read_constant(int from, int to) {
    if (!tensor(from).is_constant() || tensor(to).is_constant() || tensor(from).shape != tensor(to).shape)
      return bad_layer("unpacks what is not a constant");
    // Moved: the packed copy of the weights is of no use any more.
    tensor(to).values = std::move(tensor(from).values);
    tensor(from).values.clear();
    return {};
  }

  Result<void> finish(Layer& layer, int activation) {
    if (activation != 0 && activation != 3)
      return bad_layer("has an activation of kind " + std::to_string(activation));
    layer.activation = activation == 3 ? Activation::Relu6 : Activation::None;
    const bool knows_activation = layer.kind == LayerKind::Convolution || layer.kind == LayerKind::Add ||
                                  layer.kind == LayerKind::DepthwiseConvolution;
    if (layer.activation != Activation::None && !knows_activation)
      return bad_layer("has an activation where none is known");
    graph_.layers.push_back(layer);
    return {};
  }

  // The two names for paddings: SAME keeps ceil(size / stride), VALID pads nothing.
  bool set_window(Layer& layer, int padding, int width, int height) {
    const std::vector<int>& in = tensor(layer.inputs[0]).shape;
    const auto in_range = [](int step) { return step >= 1 && step <= kLargestStep; };
    if (in.size() != 4 || !in_range(layer.stride_x) || !in_range(layer.stride_y) || !in_range(width) ||
        !in_range(height) || padding < 0 || padding > 1)
      return false;
    if (padding == 1) return true;
    const auto missing = [](int extent, int stride, int window) {
      const int outputs = (extent - 1) / stride + 1;
      return static_cast<int>(
          std::max<std::int64_t>(0, std::int64_t{outputs - 1} * stride + window - std::int64_t{extent}));
    };
    const int across = missing(in[2], layer.stride_x, width);
    const int down = missing(in[1], layer.stride_y, height);
    layer.padding.left = across / 2;
    layer.padding.right = across - across / 2;
    layer.padding.top = down / 2;
    layer.padding.bottom = down - down / 2;
    return true;
  }

  Result<void> read_convolution(Layer& layer, LayerKind kind, const std::vector<int>& inputs,
                                const FlatTable& options) {
    layer.kind = kind;
    const bool depthwise = kind == LayerKind::DepthwiseConvolution;
    if (inputs.size() < 2 || !is_tensor(inputs[1]) || tensor(inputs[1]).shape.size() != 4)
      return bad_layer("is a convolution without a filter");
    layer.filter = inputs[1];
    layer.bias = inputs.size() > 2 ? inputs[2] : kNoTensor;
    layer.stride_x = options.number<std::int32_t>(1);
    layer.stride_y = options.number<std::int32_t>(2);
    // Depthwise options hold their depth multiplier before the activation.
    if (depthwise && options.number<std::int32_t>(3) != 1) return bad_layer("multiplies channels");
    const int dilation_slot = depthwise ? 5 : 4;
    if (options.number<std::int32_t>(dilation_slot, 1) != 1 ||
        options.number<std::int32_t>(dilation_slot + 1, 1) != 1)
      return bad_layer("is a dilated convolution");
    const std::vector<int>& filter = tensor(layer.filter).shape;
    if (!set_window(layer, options.number<std::int8_t>(0), filter[2], filter[1]))
      return bad_layer("has a strange window");
    return finish(layer, options.number<std::int8_t>(depthwise ? 4 : 3));
  }

  Result<void> read_pool(Layer& layer, const FlatTable& options) {
    layer.kind = LayerKind::MaxPool;
    layer.stride_x = options.number<std::int32_t>(1);
    layer.stride_y = options.number<std::int32_t>(2);
    layer.window_width = options.number<std::int32_t>(3);
    layer.window_height = options.number<std::int32_t>(4);
    if (!set_window(layer, options.number<std::int8_t>(0), layer.window_width, layer.window_height))
      return bad_layer("has a strange window");
    if (layer.padding != Padding{}) return bad_layer("pools over an edge");
    return finish(layer, options.number<std::int8_t>(5));
  }

  Result<void> read_pad(Layer& layer, const std::vector<int>& inputs) {
    layer.kind = LayerKind::Pad;
    const std::string_view data =
        inputs.size() == 2 && is_tensor(inputs[1]) ? integers_[static_cast<std::size_t>(inputs[1])] : "";
    std::int32_t pads[8] = {};
    if (data.size() != sizeof pads) return bad_layer("pads by an unknown amount");
    std::memcpy(pads, data.data(), sizeof pads);
    const bool in_range =
        std::all_of(std::begin(pads), std::end(pads), [](int n) { return n >= 0 && n <= kLargestStep; });
    if (!in_range || pads[0] != 0 || pads[1] != 0 || pads[6] != 0) return bad_layer("pads in an unknown way");
    layer.padding = {pads[4], pads[5], pads[2], pads[3], pads[7]};
    return finish(layer, 0);
  }

  Flatbuffer file_;
  std::string name_;
  NetworkGraph graph_;
  std::vector<int> codes_;
  std::vector<std::string_view> integers_;  // by tensor: the bytes of 32-bit integer constants
  std::size_t layer_ = 0;
};

}  // namespace

Result<NetworkGraph> read_tflite(std::string_view bytes, const std::string& name) {
  return Reader(bytes, name).read();
}

}  // namespace posecoach
