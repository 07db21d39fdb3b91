#include "app/train/train_retarget_command.h"

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <memory>

#include "core/retarget/network/training.h"

namespace posecoach {
namespace {

std::atomic<bool> stop_asked{false};

void ask_to_stop(int) {
  stop_asked = true;
}

bool print(const TrainingReport& report) {
  std::string line;
  for (const auto& [name, value] : report.values) {
    char text[64];
    std::snprintf(text, sizeof text, "  %s %.3g", name.c_str(), value);
    line += text;
  }
  std::fprintf(stderr, "%6.1f of %.0f min  step %ld%s\n", report.minutes, report.of_minutes, report.iteration,
               line.c_str());
  return true;
}

Result<void> train(TrainingOptions options, const std::string& method, const std::string& variant) {
  options.method = method == "network" ? TrainedMethod::Network : TrainedMethod::Paper;
  const Result<PaperVariant> known = paper_variant_from_string(variant);
  if (!known) return tl::unexpected(known.error());
  options.variant = *known;
  std::signal(SIGINT, ask_to_stop);
  std::signal(SIGTERM, ask_to_stop);
  options.stop = [] { return stop_asked.load(); };
  options.watch = print;
  const Result<TrainingSummary> done = train_retargeting(options);
  if (!done) return tl::unexpected(done.error());
  std::printf("%s after %ld steps; best held-out error %.3g, geometry alone %.3g%s\n",
              done->finished ? "finished" : "stopped", done->iterations, done->best_error,
              done->geometry_error,
              done->best_error > done->geometry_error ? " (these weights are worse than geometry)" : "");
  if (!done->finished) std::printf("go on with the same command and --resume\n");
  return {};
}

}  // namespace

void add_train_retarget_command(CLI::App& train_command, Action& action) {
  CLI::App* command = train_command.add_subcommand("retarget", "Train a retargeting network");
  struct Settings {
    TrainingOptions options;
    std::string method = "network", variant = "paper";
  };
  const auto settings = std::make_shared<Settings>();
  command->add_option("--data", settings->options.data, "Folder of motions (.bvh, .amc)")->required();
  command->add_option("-o,--output", settings->options.weights, "File of weights to write")->required();
  command->add_option("--method", settings->method, "What to train")
      ->check(CLI::IsMember({"network", "paper"}))
      ->capture_default_str();
  command->add_option("--variant", settings->variant, "Ablation of the paper's network")
      ->capture_default_str();
  command->add_option("--minutes", settings->options.minutes, "How long, on one core")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--seed", settings->options.seed, "Of all random choices")->capture_default_str();
  command->add_option("--batch", settings->options.batch, "Windows a step")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command->add_flag("--resume", settings->options.resume, "Go on where an earlier training stopped");
  command->callback([settings, &action] {
    action = [settings] { return train(settings->options, settings->method, settings->variant); };
  });
}

}  // namespace posecoach
