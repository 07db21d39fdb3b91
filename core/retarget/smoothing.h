// Smoothing by time, whatever the frame rate and however uneven.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "core/base/math.h"
#include "core/base/time.h"

namespace posecoach {

// First and last frame whose time is within `half_s` of frame i's.
std::pair<std::size_t, std::size_t> frames_within(std::span<const MediaTime> times, std::size_t i,
                                                  double half_s);

// Gaussian; straight lines stay straight away from the ends.
std::vector<Vec3> smoothed_over_time(std::span<const Vec3> values, std::span<const MediaTime> times,
                                     double sigma_s);

// From 0 at `from` to 1 at `to`, with no kink at either end.
double smooth_step(double from, double to, double x);

}  // namespace posecoach
