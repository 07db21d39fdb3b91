// The numbers of the status line: rates over the last two seconds, latency over the last 120 poses.
#pragma once

#include <chrono>
#include <deque>

#include "core/pipeline/coach_snapshot.h"

namespace posecoach {

class RateMeter {
 public:
  void count(std::chrono::steady_clock::time_point now);
  double per_second(std::chrono::steady_clock::time_point now) const;
  void reset() { times_.clear(); }

 private:
  std::deque<std::chrono::steady_clock::time_point> times_;
};

class LatencyMeter {
 public:
  void add(std::chrono::steady_clock::duration latency);
  // Median and 95th percentile; zeros before the first.
  void fill(LiveCounters& counters) const;
  void reset() { latencies_ms_.clear(); }

 private:
  std::deque<double> latencies_ms_;
};

}  // namespace posecoach
