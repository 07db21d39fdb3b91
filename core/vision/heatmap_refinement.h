// Moves landmarks to where the network's heatmap is warm around them.
#pragma once

#include <span>

#include "core/base/math.h"

namespace posecoach {

inline constexpr int kHeatmapSize = 64;

// `heatmap` is (row, column, channel) raw numbers, kHeatmapSize squared times `channels`. The point, in [0,
// 1] of the square, becomes the mean, weighted by the heatmap's logistic values, of the 7 x 7 cells around
// its own cell, provided that one of them reaches one half. Cells count by their upper left corner, as the
// network was trained.
Vec2 refined_by_heatmap(const Vec2& point, std::span<const float> heatmap, int channel, int channels);

}  // namespace posecoach
