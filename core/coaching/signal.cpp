#include "core/coaching/signal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/base/assert.h"
#include "core/base/index.h"

namespace posecoach {
namespace {

template <typename T>
std::vector<T> gaussian(const std::vector<T>& values, double sigma) {
  if (sigma <= 0.05) return values;
  const int reach = static_cast<int>(std::ceil(3 * sigma));
  const int count = static_cast<int>(values.size());
  std::vector<double> kernel;
  for (int d = 0; d <= reach; ++d) kernel.push_back(std::exp(-0.5 * d * d / (sigma * sigma)));
  std::vector<T> result;
  result.reserve(values.size());
  for (int i = 0; i < count; ++i) {
    T sum{};
    double total = 0;
    // Only as far as both sides reach, so that an end is not pulled inwards.
    const int symmetric = std::min({reach, i, count - 1 - i});
    for (int d = -symmetric; d <= symmetric; ++d) {
      const double weight = kernel[index(std::abs(d))];
      sum += weight * values[index(i + d)];
      total += weight;
    }
    result.push_back(sum / total);
  }
  return result;
}

}  // namespace

std::vector<double> smoothed(const std::vector<double>& values, double sigma) {
  return gaussian(values, sigma);
}

std::vector<Vec3> smoothed(const std::vector<Vec3>& values, double sigma) {
  return gaussian(values, sigma);
}

std::vector<double> speed_of(const std::vector<Vec3>& positions, double rate) {
  const int count = static_cast<int>(positions.size());
  std::vector<double> speed(positions.size(), 0.0);
  for (int i = 0; i < count; ++i) {
    const int a = std::max(0, i - 1), b = std::min(count - 1, i + 1);
    if (b > a) speed[index(i)] = glm::distance(positions[index(a)], positions[index(b)]) * rate / (b - a);
  }
  return speed;
}

double vertex_near(const std::vector<double>& values, int i) {
  if (i <= 0 || i + 1 >= static_cast<int>(values.size())) return i;
  const double a = values[index(i - 1)], b = values[index(i)], c = values[index(i + 1)];
  const double bend = a - 2 * b + c;
  return bend == 0 ? i : i + std::clamp(0.5 * (a - c) / bend, -1.0, 1.0);
}

double peak_of_curve(const std::vector<double>& values, int i, double half, int degree) {
  POSECOACH_ASSERT(half >= degree && (degree == 2 || degree == 3));
  constexpr int kMostTerms = 4;
  const int terms = degree + 1, last = static_cast<int>(values.size()) - 1;
  const int first = std::max(0, static_cast<int>(std::ceil(i - half))),
            end = std::min(last, static_cast<int>(std::floor(i + half)));
  if (end - first < degree) return i;
  // Normal equations, the right side in the last column.
  std::array<std::array<double, kMostTerms + 1>, kMostTerms> rows{};
  for (int k = first; k <= end; ++k) {
    std::array<double, kMostTerms> power{1};
    for (std::size_t term = 1; term < kMostTerms; ++term) power[term] = power[term - 1] * (k - i) / half;
    for (std::size_t row = 0; row < index(terms); ++row) {
      for (std::size_t column = 0; column < index(terms); ++column)
        rows[row][column] += power[row] * power[column];
      rows[row][kMostTerms] += power[row] * values[index(k)];
    }
  }
  // Positive definite: no pivoting is needed.
  for (std::size_t pivot = 0; pivot < index(terms); ++pivot)
    for (std::size_t row = 0; row < index(terms); ++row) {
      if (row == pivot) continue;
      const double factor = rows[row][pivot] / rows[pivot][pivot];
      for (std::size_t column = 0; column <= kMostTerms; ++column)
        rows[row][column] -= factor * rows[pivot][column];
    }
  constexpr int kPlaces = 200;
  double best = i, highest = -std::numeric_limits<double>::infinity();
  for (int place = 0; place <= kPlaces; ++place) {
    const double t = ((end - first) * static_cast<double>(place) / kPlaces + first - i) / half;
    double value = 0, power = 1;
    for (std::size_t term = 0; term < index(terms); ++term, power *= t)
      value += power * rows[term][kMostTerms] / rows[term][term];
    if (value <= highest) continue;
    highest = value;
    best = i + t * half;
  }
  return best;
}

int index_of_largest(const std::vector<double>& values, int first, int last) {
  return static_cast<int>(std::max_element(values.begin() + first, values.begin() + last + 1) -
                          values.begin());
}

int index_of_smallest(const std::vector<double>& values, int first, int last) {
  return static_cast<int>(std::min_element(values.begin() + first, values.begin() + last + 1) -
                          values.begin());
}

std::optional<double> crossing(const std::vector<double>& values, int from, int to, double level) {
  const int step = from <= to ? 1 : -1;
  for (int i = from; i != to; i += step) {
    const double a = values[index(i)] - level, b = values[index(i + step)] - level;
    if (a == 0) return i;
    if ((a < 0) != (b < 0)) return i + step * a / (a - b);
  }
  return std::nullopt;
}

std::vector<Extreme> extremes(const std::vector<double>& values, double prominence) {
  std::vector<Extreme> found;
  int low = 0, high = 0;
  bool rising = true, known = false;
  for (int i = 1; i < static_cast<int>(values.size()); ++i) {
    if (values[index(i)] > values[index(high)]) high = i;
    if (values[index(i)] < values[index(low)]) low = i;
    if ((!known || rising) && values[index(high)] - values[index(i)] >= prominence) {
      found.push_back({high, true});
      rising = false;
      known = true;
      low = high = i;
    } else if ((!known || !rising) && values[index(i)] - values[index(low)] >= prominence) {
      found.push_back({low, false});
      rising = true;
      known = true;
      low = high = i;
    }
  }
  if (known) found.push_back({rising ? high : low, rising});
  return found;
}

double value_at(const std::vector<double>& values, double place) {
  const int last = static_cast<int>(values.size()) - 1;
  const double clamped = std::clamp(place, 0.0, static_cast<double>(last));
  const int left = std::min(static_cast<int>(clamped), std::max(0, last - 1));
  const int right = std::min(left + 1, last);
  return values[index(left)] + (clamped - left) * (values[index(right)] - values[index(left)]);
}

}  // namespace posecoach
