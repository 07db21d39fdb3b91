#include "core/vision/buffer_plan.h"

#include <algorithm>
#include <numeric>

namespace posecoach {
namespace {

class Planner {
 public:
  explicit Planner(const NetworkGraph& graph)
      : graph_(graph), root_(graph.tensors.size()), last_use_(graph.tensors.size(), 0) {
    std::iota(root_.begin(), root_.end(), std::size_t{0});
  }

  BufferPlan plan() {
    share_reshaped_tensors();
    find_last_uses();
    share_summands();
    assign();
    return std::move(plan_);
  }

 private:
  // Never reached by a layer's number: the tensor lives as long as the network.
  static constexpr std::size_t kForever = ~std::size_t{0};

  std::size_t& root(int tensor) { return root_[static_cast<std::size_t>(tensor)]; }
  std::size_t& last_use(int tensor) { return last_use_[root(tensor)]; }

  void share_reshaped_tensors() {
    for (const Layer& layer : graph_.layers)
      if (layer.kind == LayerKind::Reshape) root(layer.output) = root(layer.inputs[0]);
  }

  void find_last_uses() {
    for (std::size_t i = 0; i < graph_.layers.size(); ++i) {
      last_use(graph_.layers[i].output) = std::max(last_use(graph_.layers[i].output), i);
      for (const int input : graph_.layers[i].inputs) last_use(input) = std::max(last_use(input), i);
      if (graph_.layers[i].added != kNoTensor) last_use(graph_.layers[i].added) = i;
    }
    for (const int tensor : graph_.inputs) last_use(tensor) = kForever;
    for (const int tensor : graph_.outputs) last_use(tensor) = kForever;
  }

  void share_summands() {
    for (std::size_t i = 0; i < graph_.layers.size(); ++i) {
      const Layer& layer = graph_.layers[i];
      if (layer.added == kNoTensor || last_use(layer.added) != i) continue;
      if (root(layer.inputs[0]) == root(layer.added)) continue;
      const std::size_t shared = root(layer.added);
      const std::size_t merged = root(layer.output);
      last_use_[shared] = std::max(last_use_[shared], last_use_[merged]);
      std::replace(root_.begin(), root_.end(), merged, shared);
    }
  }

  std::size_t take_buffer(std::size_t elements) {
    std::size_t best = free_.size();
    for (std::size_t k = 0; k < free_.size(); ++k) {
      const std::size_t size = plan_.buffer_elements[free_[k]];
      if (size >= elements && (best == free_.size() || size < plan_.buffer_elements[free_[best]])) best = k;
    }
    if (best == free_.size()) {
      plan_.buffer_elements.push_back(elements);
      return plan_.buffer_elements.size() - 1;
    }
    const std::size_t buffer = free_[best];
    free_.erase(free_.begin() + static_cast<std::ptrdiff_t>(best));
    return buffer;
  }

  void assign() {
    plan_.buffer_of_tensor.assign(graph_.tensors.size(), BufferPlan::kNoBuffer);
    std::vector<std::size_t> buffer_of_root(graph_.tensors.size(), BufferPlan::kNoBuffer);
    const auto give = [&](int tensor) {
      std::size_t& buffer = buffer_of_root[root(tensor)];
      if (buffer == BufferPlan::kNoBuffer) buffer = take_buffer(graph_.at(tensor).element_count());
      plan_.buffer_of_tensor[static_cast<std::size_t>(tensor)] = buffer;
    };
    for (const int input : graph_.inputs) give(input);
    for (std::size_t i = 0; i < graph_.layers.size(); ++i) {
      give(graph_.layers[i].output);
      std::vector<std::size_t> done;
      for (const int input : graph_.layers[i].inputs) done.push_back(root(input));
      if (graph_.layers[i].added != kNoTensor) done.push_back(root(graph_.layers[i].added));
      done.push_back(root(graph_.layers[i].output));
      std::sort(done.begin(), done.end());
      done.erase(std::unique(done.begin(), done.end()), done.end());
      for (const std::size_t tensor : done)
        if (last_use_[tensor] == i) free_.push_back(buffer_of_root[tensor]);
    }
  }

  const NetworkGraph& graph_;
  BufferPlan plan_;
  std::vector<std::size_t> root_;  // the tensor whose memory this one shares
  std::vector<std::size_t> last_use_;
  std::vector<std::size_t> free_;
};

}  // namespace

BufferPlan plan_buffers(const NetworkGraph& graph) {
  return Planner(graph).plan();
}

}  // namespace posecoach
