#include "core/retarget/smoothing.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace posecoach {

std::pair<std::size_t, std::size_t> frames_within(std::span<const MediaTime> times, std::size_t i,
                                                  double half_s) {
  const Duration half = duration_from_seconds(half_s);
  std::size_t first = i, last = i;
  while (first > 0 && times[i] - times[first - 1] <= half) --first;
  while (last + 1 < times.size() && times[last + 1] - times[i] <= half) ++last;
  return {first, last};
}

std::vector<Vec3> smoothed_over_time(std::span<const Vec3> values, std::span<const MediaTime> times,
                                     double sigma_s) {
  POSECOACH_ASSERT(values.size() == times.size() && sigma_s > 0);
  std::vector<Vec3> result(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto [first, last] = frames_within(times, i, 3 * sigma_s);
    double weights = 0;
    for (std::size_t j = first; j <= last; ++j) {
      const double off = to_seconds(times[j] - times[i]) / sigma_s;
      const double weight = std::exp(-0.5 * off * off);
      result[i] += weight * values[j];
      weights += weight;
    }
    result[i] /= weights;
  }
  return result;
}

double smooth_step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

}  // namespace posecoach
