#include <algorithm>
#include <optional>

#include "core/vision/network_graph.h"

namespace posecoach {
namespace {

bool is_convolution(const Layer& layer) {
  return layer.kind == LayerKind::Convolution || layer.kind == LayerKind::DepthwiseConvolution;
}

void drop_layers_that_nobody_needs(NetworkGraph& graph) {
  std::vector<bool> needed(graph.tensors.size(), false);
  const auto need = [&](int tensor) {
    if (tensor != kNoTensor) needed[static_cast<std::size_t>(tensor)] = true;
  };
  for (const int output : graph.outputs) need(output);
  std::vector<Layer> kept;
  for (auto layer = graph.layers.rbegin(); layer != graph.layers.rend(); ++layer) {
    if (!needed[static_cast<std::size_t>(layer->output)]) continue;
    for (const int input : layer->inputs) need(input);
    need(layer->added);
    kept.push_back(std::move(*layer));
  }
  std::reverse(kept.begin(), kept.end());
  graph.layers = std::move(kept);
}

void fold_paddings_into_convolutions(NetworkGraph& graph) {
  std::vector<bool> is_output(graph.tensors.size(), false);
  for (const int output : graph.outputs) is_output[static_cast<std::size_t>(output)] = true;
  for (const Layer& pad : std::vector<Layer>(graph.layers)) {
    if (pad.kind != LayerKind::Pad || pad.padding.channels != 0 ||
        is_output[static_cast<std::size_t>(pad.output)])
      continue;
    const auto reads_it = [&](const Layer& layer) {
      return layer.added == pad.output ||
             std::find(layer.inputs.begin(), layer.inputs.end(), pad.output) != layer.inputs.end();
    };
    const bool foldable = std::all_of(graph.layers.begin(), graph.layers.end(), [&](const Layer& layer) {
      return !reads_it(layer) || (is_convolution(layer) && layer.added != pad.output);
    });
    if (!foldable) continue;
    for (Layer& layer : graph.layers) {
      if (!reads_it(layer)) continue;
      layer.inputs[0] = pad.inputs[0];
      layer.padding.left += pad.padding.left;
      layer.padding.right += pad.padding.right;
      layer.padding.top += pad.padding.top;
      layer.padding.bottom += pad.padding.bottom;
    }
  }
  drop_layers_that_nobody_needs(graph);
}

// The convolution takes the sum's place in the order, where both summands are known.
void fold_sums_into_convolutions(NetworkGraph& graph) {
  const std::vector<int> uses = count_uses(graph);
  std::vector<std::optional<std::size_t>> producer(graph.tensors.size());
  std::vector<bool> absorbed(graph.layers.size(), false);
  for (std::size_t i = 0; i < graph.layers.size(); ++i) {
    Layer& sum = graph.layers[i];
    producer[static_cast<std::size_t>(sum.output)] = i;
    if (sum.kind != LayerKind::Add || sum.inputs[0] == sum.inputs[1]) continue;
    std::optional<std::size_t> best;
    for (const int summand : sum.inputs) {
      const auto made_by = producer[static_cast<std::size_t>(summand)];
      if (!made_by || uses[static_cast<std::size_t>(summand)] != 1) continue;
      const Layer& layer = graph.layers[*made_by];
      if (!is_convolution(layer) || layer.activation != Activation::None || layer.added != kNoTensor)
        continue;
      if (!best || *made_by > *best) best = *made_by;
    }
    if (!best) continue;
    Layer merged = graph.layers[*best];
    merged.added = sum.inputs[0] == merged.output ? sum.inputs[1] : sum.inputs[0];
    merged.activation = sum.activation;
    merged.output = sum.output;
    absorbed[*best] = true;
    sum = std::move(merged);
  }
  std::vector<Layer> kept;
  for (std::size_t i = 0; i < graph.layers.size(); ++i)
    if (!absorbed[i]) kept.push_back(std::move(graph.layers[i]));
  graph.layers = std::move(kept);
}

}  // namespace

Result<NetworkGraph> simplified_graph(NetworkGraph graph, const std::vector<std::string>& outputs) {
  std::vector<int> chosen;
  for (const std::string& name : outputs) {
    const auto found = std::find_if(graph.outputs.begin(), graph.outputs.end(),
                                    [&](int output) { return graph.at(output).name == name; });
    if (found == graph.outputs.end())
      return fail(ErrorCode::NotFound, "the network has no output named " + name);
    chosen.push_back(*found);
  }
  graph.outputs = std::move(chosen);
  drop_layers_that_nobody_needs(graph);
  fold_paddings_into_convolutions(graph);
  fold_sums_into_convolutions(graph);
  return graph;
}

}  // namespace posecoach
