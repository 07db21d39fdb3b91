// The layers that only move numbers around, or are too small to matter: done without a library. Pictures are
// (row, column, channel); spans have the sizes that check_graph found.
#pragma once

#include <span>
#include <vector>

#include "core/vision/network_graph.h"

namespace posecoach {

// Zeros around, and zero channels behind.
void run_pad(const Layer& layer, const std::vector<int>& in_shape, std::span<const float> in,
             std::span<float> out);

void run_depth_to_space(int block, const std::vector<int>& in_shape, std::span<const float> in,
                        std::span<float> out);

// `part_runs[i]`: how many values of input i lie together along the axis and what follows it.
void run_concatenate(const std::vector<std::span<const float>>& parts,
                     const std::vector<std::size_t>& part_runs, std::span<float> out);

void run_logistic(std::span<const float> in, std::span<float> out);

double logistic(double x);

}  // namespace posecoach
