#include "core/motion/authored/key_curve.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/base/assert.h"

namespace posecoach {
namespace {

// Slopes of the cubic spline with zero slope at both ends.
std::vector<double> clamped_spline_slopes(std::span<const CurveKey> keys) {
  const std::size_t n = keys.size();
  std::vector<double> diagonal(n, 1.0), upper(n, 0.0), slope(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double before = keys[i].time_s - keys[i - 1].time_s, after = keys[i + 1].time_s - keys[i].time_s;
    const double rise_before = (keys[i].value - keys[i - 1].value) / before;
    const double rise_after = (keys[i + 1].value - keys[i].value) / after;
    const double factor = after / diagonal[i - 1];
    diagonal[i] = 2 * (before + after) - factor * upper[i - 1];
    upper[i] = before;
    slope[i] = 3 * (after * rise_before + before * rise_after) - factor * slope[i - 1];
  }
  for (std::size_t i = n - 1; i-- > 1;) slope[i] = (slope[i] - upper[i] * slope[i + 1]) / diagonal[i];
  slope.front() = slope.back() = 0;
  return slope;
}

}  // namespace

KeyCurve::KeyCurve(std::span<const CurveKey> keys) {
  if (keys.empty()) return;
  for (std::size_t i = 1; i < keys.size(); ++i) POSECOACH_ASSERT(keys[i].time_s > keys[i - 1].time_s);
  std::vector<double> slope(keys.size(), 0.0);
  if (keys.size() > 2) slope = clamped_spline_slopes(keys);
  for (std::size_t i = 0; i < keys.size(); ++i)
    knots_.push_back({keys[i].time_s, keys[i].value, slope[i], 0});
  for (std::size_t i = 1; i + 1 < knots_.size(); ++i) {
    const Knot &a = knots_[i - 1], &c = knots_[i + 1];
    Knot& b = knots_[i];
    const double before = b.time - a.time, after = c.time - b.time;
    const double rise_before = (b.value - a.value) / before, rise_after = (c.value - b.value) / after;
    if (rise_before * rise_after <= 0) {
      b.velocity = 0;
    } else {
      const double limit = 3 * std::min(std::abs(rise_before), std::abs(rise_after));
      b.velocity = std::clamp(b.velocity, -limit, limit);
      if (b.velocity * rise_before < 0) b.velocity = 0;
    }
  }
  // The two cubic pieces that meet at a key ask for different accelerations: take the gentler one, which
  // keeps a long piece from bulging under the demands of a short neighbour.
  for (std::size_t i = 1; i + 1 < knots_.size(); ++i) {
    const Knot &a = knots_[i - 1], &c = knots_[i + 1];
    Knot& b = knots_[i];
    const double before = b.time - a.time, after = c.time - b.time;
    const double rise_before = (b.value - a.value) / before, rise_after = (c.value - b.value) / after;
    const double from_before = (2 * a.velocity + 4 * b.velocity - 6 * rise_before) / before;
    const double from_after = (6 * rise_after - 4 * b.velocity - 2 * c.velocity) / after;
    if (from_before * from_after > 0)
      b.acceleration = std::copysign(std::min(std::abs(from_before), std::abs(from_after)), from_before);
  }
}

double KeyCurve::value(double time_s) const {
  if (knots_.empty()) return 0;
  if (time_s <= knots_.front().time) return knots_.front().value;
  if (time_s >= knots_.back().time) return knots_.back().value;
  const auto right = std::upper_bound(knots_.begin(), knots_.end(), time_s,
                                      [](double t, const Knot& knot) { return t < knot.time; });
  const Knot &b = *right, &a = *(right - 1);
  const double h = b.time - a.time, u = (time_s - a.time) / h;
  const double v0 = a.velocity * h, v1 = b.velocity * h;
  const double a0 = a.acceleration * h * h, a1 = b.acceleration * h * h;
  const double rise = b.value - a.value;
  const double c3 = 10 * rise - 6 * v0 - 4 * v1 - 1.5 * a0 + 0.5 * a1;
  const double c4 = -15 * rise + 8 * v0 + 7 * v1 + 1.5 * a0 - a1;
  const double c5 = 6 * rise - 3 * (v0 + v1) - 0.5 * (a0 - a1);
  return a.value + u * (v0 + u * (0.5 * a0 + u * (c3 + u * (c4 + u * c5))));
}

}  // namespace posecoach
