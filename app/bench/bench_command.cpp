#include "app/bench/bench_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/bench/bench.h"
#include "core/base/assert.h"
#include "core/base/file.h"

namespace posecoach {
namespace {

void print_rows(const std::vector<BenchRow>& rows) {
  std::printf("%-44s %11s %11s %6s\n", "stage", "median ms", "min ms", "n");
  for (const BenchRow& row : rows)
    std::printf("%-44s %11.3f %11.3f %6zu\n", row.name.c_str(), row.median_ms, row.min_ms, row.n);
}

std::string json_of(const std::vector<BenchRow>& rows) {
  nlohmann::json answer = {{"schema", "posecoach.bench/1"}, {"rows", nlohmann::json::array()}};
  for (const BenchRow& row : rows)
    answer["rows"].push_back(
        {{"name", row.name}, {"median_ms", row.median_ms}, {"min_ms", row.min_ms}, {"n", row.n}});
  return answer.dump(1) + "\n";
}

Result<void> run_soak(const BenchOptions& options, double minutes, const std::string& json) {
  std::vector<BenchRow> rows;
  if (const auto done = bench_soak(options, minutes, rows); !done) return done;
  return json.empty() ? Result<void>() : write_file_atomically(json, json_of(rows));
}

Result<void> run(const BenchOptions& options, const std::string& json) {
  std::vector<BenchRow> rows;
  for (const auto part : {bench_vision, bench_retarget, bench_transfer, bench_coaching, bench_live,
                          bench_record, bench_session, bench_render, bench_window})
    if (const auto done = part(options, rows); !done) return done;
  if (json != "-") print_rows(rows);
  return json.empty() ? Result<void>() : write_file_atomically(json, json_of(rows));
}

}  // namespace

BenchRow make_bench_row(std::string name, std::vector<double> times_ms) {
  POSECOACH_ASSERT(!times_ms.empty());
  std::sort(times_ms.begin(), times_ms.end());
  return {std::move(name), times_ms[times_ms.size() / 2], times_ms.front(), times_ms.size()};
}

double milliseconds_of(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

BenchRow measure(std::string name, std::size_t n, const std::function<void()>& work) {
  work();
  work();
  std::vector<double> times_ms;
  for (std::size_t i = 0; i < n; ++i) times_ms.push_back(milliseconds_of(work));
  return make_bench_row(std::move(name), std::move(times_ms));
}

void add_bench_command(CLI::App& cli, Action& action) {
  CLI::App* command = cli.add_subcommand("bench", "Speed of every stage, on one thread");
  auto options = std::make_shared<BenchOptions>();
  auto json = std::make_shared<std::string>();
  command->add_option("--film", options->film, "A film of a person, for the whole pose stage")
      ->type_name("FILE");
  command->add_option("--models", options->models, "Folder of the pose networks")->type_name("DIR");
  command->add_option("--json", *json, "Write the table as JSON; - for standard output")->type_name("FILE");
  auto minutes = std::make_shared<double>(0);
  command
      ->add_option(
          "--soak", *minutes,
          "Instead: the live loop at the film's own pace, for so many minutes; does lag or memory grow?")
      ->type_name("MINUTES")
      ->check(CLI::Range(1.0, 1440.0));
  command->callback([&action, options, json, minutes] {
    action = [options, json, minutes] {
      return *minutes > 0 ? run_soak(*options, *minutes, *json) : run(*options, *json);
    };
  });
}

}  // namespace posecoach
