#include "core/vision/heatmap_refinement.h"

#include <algorithm>

#include "core/vision/plain_layers.h"

namespace posecoach {

Vec2 refined_by_heatmap(const Vec2& point, std::span<const float> heatmap, int channel, int channels) {
  constexpr int kReach = 3;
  constexpr double kWarm = 0.5;
  // Also false for what is not a number.
  const bool inside =
      point.x > -1.0 / kHeatmapSize && point.x < 1 && point.y > -1.0 / kHeatmapSize && point.y < 1;
  if (!inside) return point;
  const int centre_column = static_cast<int>(point.x * kHeatmapSize);
  const int centre_row = static_cast<int>(point.y * kHeatmapSize);
  double warmest = 0;
  double sum = 0;
  Vec2 moment;
  for (int row = std::max(0, centre_row - kReach); row <= std::min(kHeatmapSize - 1, centre_row + kReach);
       ++row)
    for (int column = std::max(0, centre_column - kReach);
         column <= std::min(kHeatmapSize - 1, centre_column + kReach); ++column) {
      const auto cell = static_cast<std::size_t>((row * kHeatmapSize + column) * channels + channel);
      const double warmth = logistic(static_cast<double>(heatmap[cell]));
      warmest = std::max(warmest, warmth);
      sum += warmth;
      moment += warmth * Vec2(column, row);
    }
  if (warmest < kWarm) return point;
  return moment / (sum * kHeatmapSize);
}

}  // namespace posecoach
