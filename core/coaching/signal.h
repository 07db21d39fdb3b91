// Small tools for sampled curves at a constant rate.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/base/math.h"

namespace posecoach {

// Gaussian mean without delay; `sigma` in samples. The ends see only what there is.
std::vector<double> smoothed(const std::vector<double>& values, double sigma);
std::vector<Vec3> smoothed(const std::vector<Vec3>& values, double sigma);

// Length of the central difference, per second.
std::vector<double> speed_of(const std::vector<Vec3>& positions, double rate);

// Vertex of the parabola through samples i - 1, i, i + 1, in samples; i itself at the ends or on a line.
double vertex_near(const std::vector<double>& values, int i);

// Where the polynomial of this degree (2 or 3) that fits the values around `i` best, as far as `half` samples
// to each side, is highest; in fractional samples, within that reach. For peaks that noise has made flat.
double peak_of_curve(const std::vector<double>& values, int i, double half, int degree);

// Indices of the largest and smallest value in [first, last].
int index_of_largest(const std::vector<double>& values, int first, int last);
int index_of_smallest(const std::vector<double>& values, int first, int last);

// The first place in [from, to] (either direction) where the values pass `level`, in fractional samples.
std::optional<double> crossing(const std::vector<double>& values, int from, int to, double level);

struct Extreme {
  int index = 0;
  bool is_peak = false;
};
// Alternating peaks and valleys that differ from their neighbours by at least `prominence`.
std::vector<Extreme> extremes(const std::vector<double>& values, double prominence);

double value_at(const std::vector<double>& values, double index);

}  // namespace posecoach
