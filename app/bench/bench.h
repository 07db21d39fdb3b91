// What the parts of `bench` share. Each part measures its own stages and adds rows.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace posecoach {

struct BenchRow {
  std::string name;
  double median_ms = 0;
  double min_ms = 0;
  std::size_t n = 0;
};

struct BenchOptions {
  std::string film;    // a real film for the stages that need one; empty: the simulated student
  std::string models;  // folder of the pose networks; empty: the usual places
};

// Median and minimum of the times.
BenchRow make_bench_row(std::string name, std::vector<double> times_ms);

// Runs `work` twice to warm up, then `n` times on the calling thread.
BenchRow measure(std::string name, std::size_t n, const std::function<void()>& work);

double milliseconds_of(const std::function<void()>& work);

Result<void> bench_coaching(const BenchOptions& options, std::vector<BenchRow>& rows);
Result<void> bench_live(const BenchOptions& options, std::vector<BenchRow>& rows);
Result<void> bench_vision(const BenchOptions& options, std::vector<BenchRow>& rows);
Result<void> bench_render(const BenchOptions& options, std::vector<BenchRow>& rows);
Result<void> bench_retarget(const BenchOptions& options, std::vector<BenchRow>& rows);
Result<void> bench_window(const BenchOptions& options, std::vector<BenchRow>& rows);
Result<void> bench_record(const BenchOptions& options, std::vector<BenchRow>& rows);
Result<void> bench_session(const BenchOptions& options, std::vector<BenchRow>& rows);
Result<void> bench_transfer(const BenchOptions& options, std::vector<BenchRow>& rows);

// The whole live loop at the film's own pace for so many minutes, the film played again and again: a line and
// a row for each minute. A queue that grows or memory that leaks shows as a rise.
Result<void> bench_soak(const BenchOptions& options, double minutes, std::vector<BenchRow>& rows);

}  // namespace posecoach
