#include "core/vision/one_euro_filter.h"

#include <cmath>

#include "core/base/assert.h"
#include "core/base/math.h"

namespace posecoach {
namespace {

// The share of the newest value in a low pass of this cutoff.
double newest_share(double cutoff_hz, double frequency_hz) {
  return 1.0 / (1.0 + frequency_hz / (2 * kPi * cutoff_hz));
}

double mix(double before, double newest, double share) {
  return before + share * (newest - before);
}

}  // namespace

OneEuroFilter::OneEuroFilter(const OneEuroOptions& options) : options_(options) {
  POSECOACH_ASSERT(options.least_cutoff_hz > 0 && options.speed_weight >= 0 && options.speed_cutoff_hz > 0);
}

double OneEuroFilter::filter(MediaTime time, double value, double scale) {
  if (!state_) {
    state_ = State{time, 0, value, value, 0};
    return value;
  }
  State& state = *state_;
  if (time <= state.time) return value;
  state.frequency_hz = 1.0 / to_seconds(time - state.time);
  state.time = time;
  const double speed = (value - state.raw) * scale * state.frequency_hz;
  state.raw = value;
  state.speed = mix(state.speed, speed, newest_share(options_.speed_cutoff_hz, state.frequency_hz));
  const double cutoff_hz = options_.least_cutoff_hz + options_.speed_weight * std::abs(state.speed);
  state.smooth = mix(state.smooth, value, newest_share(cutoff_hz, state.frequency_hz));
  return state.smooth;
}

}  // namespace posecoach
