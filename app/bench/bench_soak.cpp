#include <unistd.h>

#include <algorithm>

#include <cstdio>
#include <fstream>
#include <thread>

#include "app/bench/bench.h"
#include "app/progress_bar.h"
#include "capture/open_source.h"
#include "core/motion/bundled_motion.h"
#include "core/pipeline/pipeline_runner.h"
#include "core/vision/pose_tracker.h"

namespace posecoach {
namespace {

using Clock = std::chrono::steady_clock;

double resident_mb() {
  std::ifstream file("/proc/self/statm");
  double pages = 0, resident = 0;
  file >> pages >> resident;
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
}

// What is read off the running loop, over one minute.
struct Minute {
  std::vector<double> latency_ms;  // 95th of a hundred, of the last 120 poses each time
  std::uint64_t captured = 0, shown = 0;
  int swings = 0;
  double resident_mb = 0;
};

class Soak {
 public:
  explicit Soak(PipelineRunner& runner) : runner_(runner) {}

  // Ends early when the source does.
  Minute minute() {
    Minute minute;
    const auto first = runner_.snapshot();
    const Clock::time_point end = Clock::now() + std::chrono::minutes(1);
    while (Clock::now() < end) {
      std::this_thread::sleep_for(std::chrono::seconds(1));
      const auto now = runner_.snapshot();
      if (now->source_state == SourceState::Ended) {
        has_ended_ = true;
        break;
      }
      minute.latency_ms.push_back(now->counters.latency_p95_ms);
      if (now->swing && now->swing != swing_) ++minute.swings;
      swing_ = now->swing;
    }
    const auto last = runner_.snapshot();
    minute.captured = last->counters.captured - first->counters.captured;
    minute.shown = last->number - first->number;
    minute.resident_mb = resident_mb();
    return minute;
  }
  bool has_ended() const { return has_ended_; }

 private:
  PipelineRunner& runner_;
  std::shared_ptr<const AnalyzedSwing> swing_;
  bool has_ended_ = false;
};

}  // namespace

Result<void> bench_soak(const BenchOptions& options, double minutes, std::vector<BenchRow>& rows) {
  listen_to_interrupts();
  PoseTrackerOptions pose;
  if (!options.models.empty()) pose.models = options.models;
  auto tracker = PoseTracker::make(pose);
  if (!tracker) return tl::unexpected(tracker.error());
  Result<Motion> coach = bundled_motion("swing");
  if (!coach) return tl::unexpected(coach.error());
  PipelineRunner runner(*std::move(tracker), open_source);
  runner.request([motion = *std::move(coach)](CoachPipeline& pipeline) {
    pipeline.set_coach(motion, "bundled:swing");
    pipeline.arm();
  });
  runner.set_source({options.film.empty() ? "simulated:swing?fps=30" : options.film, AtEnd::Repeat});
  while (runner.snapshot()->number < 30) {
    const auto snapshot = runner.snapshot();
    if (snapshot->source_state == SourceState::Lost)
      return fail(ErrorCode::Unreadable, snapshot->source_message);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  Soak soak(runner);
  std::printf("%6s %9s %9s %7s %22s %12s\n", "minute", "captured", "shown", "swings",
              "95th of 100 ms (worst)", "resident MB");
  for (int k = 1; k <= minutes && !soak.has_ended() && !is_interrupted(); ++k) {
    Minute minute = soak.minute();
    if (minute.latency_ms.empty()) break;
    const BenchRow row = make_bench_row(
        "minute " + std::to_string(k) + ", 95th of a hundred, capture to snapshot", minute.latency_ms);
    const double worst = *std::max_element(minute.latency_ms.begin(), minute.latency_ms.end());
    std::printf("%6d %9llu %9llu %7d %13.1f (%6.1f) %12.0f\n", k,
                static_cast<unsigned long long>(minute.captured),
                static_cast<unsigned long long>(minute.shown), minute.swings, row.median_ms, worst,
                minute.resident_mb);
    std::fflush(stdout);
    rows.push_back(row);
  }
  return {};
}

}  // namespace posecoach
