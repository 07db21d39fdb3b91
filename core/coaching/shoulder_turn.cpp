#include "core/coaching/shoulder_turn.h"

#include <cmath>

namespace posecoach {
namespace {

constexpr double kWindow_s = 0.25, kGap_s = 0.5;
// Trembling shoulders of somebody who stands still do not reach it; a putt is five times as fast.
constexpr double kStill = 0.015;
// Of a way there and back, in which it goes as far as it is away.
constexpr double kTurn_s = 0.2;

}  // namespace

void ShoulderTurn::step(MediaTime time, double across_m) {
  const double seconds = samples_.empty() ? 0 : to_seconds(time - samples_.back().time);
  if (seconds < 0 || seconds > kGap_s) reset();
  samples_.push_back({time, across_m});
  while (samples_.size() > 2 && to_seconds(time - samples_.front().time) > kWindow_s + 1e-6)
    samples_.pop_front();
  const double count = static_cast<double>(samples_.size());
  double mean_t = 0, mean = 0, sum_tt = 0, sum_tv = 0;
  for (const Sample& sample : samples_) {
    mean_t += to_seconds(sample.time - time) / count;
    mean += sample.across_m / count;
  }
  for (const Sample& sample : samples_) {
    const double t = to_seconds(sample.time - time) - mean_t;
    sum_tt += t * t;
    sum_tv += t * (sample.across_m - mean);
  }
  place_ = mean;
  speed_ = sum_tt > 0 ? sum_tv / sum_tt : 0;
  still_s_ = std::abs(speed_) < kStill ? still_s_ + seconds : 0;
}

Vec3 ShoulderTurn::phase(double tremble_m) const {
  const double place = away_m(), speed = kTurn_s * speed_, size = std::hypot(place, speed) + tremble_m;
  return {place / size, speed / size, 0};
}

}  // namespace posecoach
