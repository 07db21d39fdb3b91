#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/analyze/analyze_command.h"
#include "app/bench/bench_command.h"
#include "app/body_command.h"
#include "app/cameras_command.h"
#include "app/commands.h"
#include "app/evaluate/evaluate_coaching_command.h"
#include "app/evaluate/evaluate_live_command.h"
#include "app/evaluate/evaluate_pose_command.h"
#include "app/evaluate/evaluate_retarget_command.h"
#include "app/evaluate/evaluate_transfer_command.h"
#include "app/library/library_command.h"
#include "app/live_command.h"
#include "app/pose_command.h"
#include "app/record_command.h"
#include "app/retarget_command.h"
#include "app/simulate/simulate_command.h"
#include "app/train/train_retarget_command.h"
#include "app/train/train_transfer_command.h"
#include "app/transfer/transfer_command.h"
#include "app/usage.h"

namespace posecoach {
namespace {

int run(int argc, char** argv) {
  CLI::App cli("Virtual Pose Coach: your coach's motion in your own body", "posecoach");
  Action action;
  cli.require_subcommand(0, 1);
  cli.set_version_flag("--version", "posecoach " POSECOACH_VERSION);
  add_live_command(cli, action);
  add_analyze_command(cli, action);
  add_cameras_command(cli, action);
  add_record_command(cli, action);
  add_pose_command(cli, action);
  add_body_command(cli, action);
  add_retarget_command(cli, action);
  add_transfer_command(cli, action);
  add_library_command(cli, action);
  CLI::App* evaluate =
      cli.add_subcommand("evaluate", "How good the parts are, against data with known answers");
  evaluate->require_subcommand(1);
  add_evaluate_coaching_command(*evaluate, action);
  add_evaluate_live_command(*evaluate, action);
  add_evaluate_pose_command(*evaluate, action);
  add_evaluate_retarget_command(*evaluate, action);
  add_evaluate_transfer_command(*evaluate, action);
  CLI::App* train = cli.add_subcommand("train", "Train the networks");
  train->require_subcommand(1);
  add_train_retarget_command(*train, action);
  add_train_transfer_command(*train, action);
  add_simulate_command(cli, action);
  add_bench_command(cli, action);
  cli.failure_message(usage_line);
  try {
    cli.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return cli.exit(error) == 0 ? 0 : 2;
  }
  const Result<void> done = action();
  if (!done) return fail_with(done.error().message);
  // What was printed may still be on its way: to a full disk, for one.
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) return fail_with("cannot write standard output");
  return 0;
}

}  // namespace
}  // namespace posecoach

int main(int argc, char** argv) {
  return posecoach::run(argc, argv);
}
