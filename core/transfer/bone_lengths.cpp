#include "core/transfer/bone_lengths.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace posecoach {
namespace {

constexpr double kPercentile = 0.95;

// Linear between the two nearest ranks.
double percentile(std::vector<double>& values, double fraction) {
  std::sort(values.begin(), values.end());
  const double place = fraction * double(values.size() - 1);
  const std::size_t below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - double(below)) * (values[above] - values[below]);
}

}  // namespace

Result<BoneLengths2d> measure_bone_lengths(std::span<const Pose2d> pictures) {
  BoneLengths2d lengths;
  double size_sum = 0, average_sum = 0;
  std::array<double, kBone2dCount> longest{};
  for (std::size_t b = 0; b < kBone2dCount; ++b) {
    std::vector<double> values;
    for (const Pose2d& picture : pictures) {
      double value = 0;
      for (const std::size_t side : {b, kBones2d[b].twin})
        if (const std::optional<Vec2> bone = bone_vector(picture, side))
          value = std::max(value, glm::length(*bone));
      if (value > 0) values.push_back(value);
    }
    if (values.empty()) continue;
    longest[b] = percentile(values, kPercentile);
    size_sum += longest[b];
    average_sum += kAverageBoneLengths[b];
  }
  if (size_sum <= 0 || !std::isfinite(size_sum))
    return fail(ErrorCode::Incomplete, "no picture shows two connected joints of the person");
  lengths.stature = size_sum / average_sum;
  for (std::size_t b = 0; b < kBone2dCount; ++b) {
    // Less than this of the average length tells of foreshortening, not of the person.
    const double least = 0.02 * kAverageBoneLengths[b] * lengths.stature;
    lengths.measured[b] = longest[b] > least;
    lengths.length[b] = lengths.measured[b] ? longest[b] : kAverageBoneLengths[b] * lengths.stature;
  }
  return lengths;
}

}  // namespace posecoach
