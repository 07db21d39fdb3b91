#include "core/pipeline/live_meter.h"

#include <algorithm>
#include <vector>

namespace posecoach {
namespace {

constexpr std::chrono::seconds kWindow(2);
constexpr std::size_t kMostLatencies = 120;

}  // namespace

void RateMeter::count(std::chrono::steady_clock::time_point now) {
  times_.push_back(now);
  while (now - times_.front() > kWindow) times_.pop_front();
}

double RateMeter::per_second(std::chrono::steady_clock::time_point now) const {
  const auto first =
      std::find_if(times_.begin(), times_.end(), [&](auto time) { return now - time <= kWindow; });
  const auto count = times_.end() - first;
  if (count < 2) return 0;
  const double seconds =
      std::chrono::duration<double>(std::max(now - *first, times_.back() - *first)).count();
  return seconds > 0 ? static_cast<double>(count - 1) / seconds : 0;
}

void LatencyMeter::add(std::chrono::steady_clock::duration latency) {
  latencies_ms_.push_back(std::chrono::duration<double, std::milli>(latency).count());
  if (latencies_ms_.size() > kMostLatencies) latencies_ms_.pop_front();
}

void LatencyMeter::fill(LiveCounters& counters) const {
  if (latencies_ms_.empty()) return;
  std::vector<double> sorted(latencies_ms_.begin(), latencies_ms_.end());
  std::sort(sorted.begin(), sorted.end());
  counters.latency_median_ms = sorted[sorted.size() / 2];
  counters.latency_p95_ms = sorted[(sorted.size() - 1) * 95 / 100];
}

}  // namespace posecoach
