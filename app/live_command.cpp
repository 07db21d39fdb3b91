#include "app/live_command.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "app/pose_options.h"
#include "app/window/run_window.h"

namespace posecoach {
namespace {

void set_up(CLI::App& command, const std::shared_ptr<LiveArguments>& arguments) {
  command
      .add_option("--source", arguments->source,
                  "A camera, a film, simulated:swing; as last time when not given")
      ->type_name("SOURCE");
  command.add_option("--coach", arguments->coach, "bundled:swing, a reference, a motion file")
      ->type_name("COACH");
  command.add_option("--profile", arguments->person, "Who practises")->type_name("NAME");
}

}  // namespace

void add_live_command(CLI::App& cli, Action& action) {
  auto arguments = std::make_shared<LiveArguments>();
  CLI::App* command = cli.add_subcommand("live", "The window: practise live, review afterwards");
  set_up(*command, arguments);
  const auto pose = add_pose_options(*command);
  command->callback([&action, arguments, pose] {
    action = [arguments, pose] {
      LiveArguments all = *arguments;
      all.pose = *pose;
      return run_window(all);
    };
  });
  // Without a command: the same. Any other command takes its place.
  set_up(cli, arguments);
  action = [arguments] { return run_window(*arguments); };
}

}  // namespace posecoach
