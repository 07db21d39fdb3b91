#include "core/coaching/way_fit.h"

#include <algorithm>
#include <cstddef>

namespace posecoach {
namespace {

// The index in [from, to] with the least error; the first of several.
template <typename Error>
std::optional<int> least(int from, int to, const Error& error) {
  std::optional<int> best;
  double smallest = 0;
  for (int i = from; i <= to; ++i) {
    const double here = error(i);
    if (best && here >= smallest) continue;
    smallest = here;
    best = i;
  }
  return best;
}

}  // namespace

double to_rest(double time) {
  return time * time * time * (10 + time * (6 * time - 15));
}
double to_turn(double time) {
  return time * time * time * (20 + time * (8 * time - 25)) / 3;
}

double misfit(const std::vector<double>& values, int first, int last,
              const std::function<double(int)>& shape) {
  const double count = last - first + 1;
  double sum_s = 0, sum_v = 0, sum_ss = 0, sum_sv = 0, sum_vv = 0;
  for (int i = first; i <= last; ++i) {
    const double s = shape(i), v = values[static_cast<std::size_t>(i)];
    sum_s += s;
    sum_v += v;
    sum_ss += s * s;
    sum_sv += s * v;
    sum_vv += v * v;
  }
  const double spread_s = sum_ss - sum_s * sum_s / count, together = sum_sv - sum_s * sum_v / count;
  const double explained = spread_s > 0 ? together * together / spread_s : 0;
  return std::max(0.0, sum_vv - sum_v * sum_v / count - explained) / count;
}

std::optional<int> fit_rest_before(const std::vector<double>& values, int earliest, int latest, int goal,
                                   int rest) {
  return least(std::max(0, earliest), std::min(latest, goal - 2), [&](int start) {
    return misfit(values, std::max(0, start - rest), goal, [&](int i) {
      return i <= start ? 0.0 : to_turn(static_cast<double>(i - start) / (goal - start));
    });
  });
}

std::optional<int> fit_rest_after(const std::vector<double>& values, int moving, int earliest, int latest,
                                  int rest) {
  const int last = static_cast<int>(values.size()) - 1;
  return least(std::max(earliest, moving + 2), std::min(latest, last), [&](int end) {
    return misfit(values, moving, std::min(last, end + rest), [&](int i) {
      return i >= end ? 1.0 : 2 * to_rest(0.5 + 0.5 * static_cast<double>(i - moving) / (end - moving)) - 1;
    });
  });
}

}  // namespace posecoach
