#include "core/vision/network.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/vision/buffer_plan.h"
#include "tests/core/vision/naive_network.h"

namespace posecoach {
namespace {

std::vector<float> make_input(const NetworkGraph& graph, std::mt19937& random) {
  std::uniform_real_distribution<float> number(-1, 1);
  std::vector<float> input(graph.at(graph.inputs[0]).element_count());
  for (float& value : input) value = number(random);
  return input;
}

std::vector<std::string> output_names(const NetworkGraph& graph) {
  std::vector<std::string> names;
  for (const int output : graph.outputs) names.push_back(graph.at(output).name);
  return names;
}

void expect_same_outputs(const NetworkGraph& graph, const std::vector<float>& input,
                         const std::vector<std::vector<float>>& expected) {
  auto network = Network::make(graph);
  ASSERT_TRUE(network) << network.error().message;
  // Twice: buffers that one run leaves behind must not change the next.
  for (int run = 0; run < 2; ++run) {
    std::copy(input.begin(), input.end(), network->input().begin());
    ASSERT_TRUE(network->run());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const auto output = network->output(i);
      ASSERT_EQ(output.size(), expected[i].size());
      for (std::size_t k = 0; k < output.size(); ++k)
        ASSERT_NEAR(output[k], expected[i][k], 1e-4F + 1e-4F * std::abs(expected[i][k])) << i << " " << k;
    }
  }
}

TEST(Network, random_networks_compute_what_the_plain_loops_compute) {
  std::mt19937 random(10);
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(round);
    const NetworkGraph graph = make_random_graph(random);
    ASSERT_TRUE(check_graph(graph)) << check_graph(graph).error().message;
    const auto input = make_input(graph, random);
    expect_same_outputs(graph, input, run_naively(graph, input));
  }
}

TEST(Network, simplifying_a_network_does_not_change_its_outputs) {
  std::mt19937 random(11);
  std::size_t layers_before = 0;
  std::size_t layers_after = 0;
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(round);
    const NetworkGraph graph = make_random_graph(random);
    const auto simple = simplified_graph(graph, output_names(graph)).value();
    ASSERT_TRUE(check_graph(simple)) << check_graph(simple).error().message;
    const auto input = make_input(graph, random);
    expect_same_outputs(simple, input, run_naively(graph, input));
    layers_before += graph.layers.size();
    layers_after += simple.layers.size();
  }
  EXPECT_LT(layers_after, layers_before);
}

TEST(Network, outputs_come_in_the_order_asked_for_and_unknown_ones_are_an_error) {
  std::mt19937 random(12);
  const NetworkGraph graph = make_random_graph(random);
  const auto input = make_input(graph, random);
  const auto all = run_naively(graph, input);
  const auto simple = simplified_graph(graph, {"out1", "out0"}).value();
  expect_same_outputs(simple, input, {all[1], all[0]});
  EXPECT_EQ(simplified_graph(graph, {"nonsense"}).error().code, ErrorCode::NotFound);
}

TEST(BufferPlan, memory_is_used_again) {
  std::mt19937 random(13);
  for (int round = 0; round < 20; ++round) {
    const NetworkGraph graph = make_random_graph(random);
    const BufferPlan plan = plan_buffers(graph);
    EXPECT_LT(plan.buffer_elements.size(), graph.layers.size());
    for (const Layer& layer : graph.layers) {
      const std::size_t buffer = plan.buffer_of_tensor[static_cast<std::size_t>(layer.output)];
      EXPECT_GE(plan.buffer_elements[buffer], graph.at(layer.output).element_count());
    }
  }
}

TEST(NetworkGraph, a_wrong_shape_is_refused) {
  std::mt19937 random(14);
  for (int round = 0; round < 20; ++round) {
    NetworkGraph graph = make_random_graph(random);
    const Layer& layer = graph.layers[static_cast<std::size_t>(round) % graph.layers.size()];
    if (layer.kind == LayerKind::ResizeBilinear) continue;  // any size is right
    graph.tensors[static_cast<std::size_t>(layer.output)].shape[1] += 1;
    const auto checked = check_graph(graph);
    ASSERT_FALSE(checked);
    EXPECT_EQ(checked.error().code, ErrorCode::Malformed);
    EXPECT_FALSE(Network::make(graph));
  }
}

TEST(NetworkGraph, layers_out_of_order_are_refused) {
  std::mt19937 random(15);
  NetworkGraph graph = make_random_graph(random);
  std::reverse(graph.layers.begin(), graph.layers.end());
  EXPECT_FALSE(check_graph(graph));
}

TEST(NetworkGraph, tensors_that_do_not_exist_are_refused) {
  std::mt19937 random(16);
  const NetworkGraph good = make_random_graph(random);
  for (const int wrong : {-2, -1, 1 << 30}) {
    NetworkGraph graph = good;
    graph.layers[3].inputs[0] = wrong;
    EXPECT_FALSE(check_graph(graph));
    graph = good;
    graph.layers[3].output = wrong;
    EXPECT_FALSE(check_graph(graph));
    graph = good;
    graph.outputs[0] = wrong;
    EXPECT_FALSE(check_graph(graph));
  }
}

}  // namespace
}  // namespace posecoach
