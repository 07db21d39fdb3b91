// Networks computed as slowly and plainly as possible, to compare the fast ones with; and random small ones.
#pragma once

#include <random>
#include <vector>

#include "core/vision/network_graph.h"

namespace posecoach {

// The outputs of a graph that passed check_graph, for one input.
std::vector<std::vector<float>> run_naively(const NetworkGraph& graph, const std::vector<float>& input);

// A picture network with every kind of layer, skips, shared inputs and side exits; named outputs "out0", ...
NetworkGraph make_random_graph(std::mt19937& random);

}  // namespace posecoach
