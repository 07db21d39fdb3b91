// Time as types that do not mix: media time (position in a film or motion, from its start) and capture time
// (CLOCK_MONOTONIC at the camera). Nothing computes time from a frame index and a nominal rate.
#pragma once

#include <chrono>
#include <cmath>

namespace posecoach {

using Duration = std::chrono::nanoseconds;

struct MediaClock {
  using duration = Duration;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<MediaClock>;
  static constexpr bool is_steady = true;
};
using MediaTime = std::chrono::time_point<MediaClock, Duration>;
using CaptureTime = std::chrono::time_point<std::chrono::steady_clock, Duration>;

constexpr double to_seconds(Duration duration) {
  return std::chrono::duration<double>(duration).count();
}
constexpr double to_seconds(MediaTime time) {
  return to_seconds(time.time_since_epoch());
}

// Rounded to the nearest nanosecond; `seconds` must be finite and below 292 years.
inline Duration duration_from_seconds(double seconds) {
  return Duration(std::llround(seconds * 1e9));
}
inline MediaTime media_time_from_seconds(double seconds) {
  return MediaTime(duration_from_seconds(seconds));
}

}  // namespace posecoach
