#include "app/body_command.h"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/load_motion.h"
#include "app/output_check.h"
#include "app/pose_options.h"
#include "app/progress_bar.h"
#include "core/body/body_file.h"
#include "core/body/body_measurement.h"

namespace posecoach {
namespace {

struct Arguments {
  std::string input, output;
  double height_m = 0;  // 0: not given
};

Result<void> run(const Arguments& arguments, const PoseTrackerOptions& pose) {
  if (const Result<void> checked = check_output_files({arguments.output}, {arguments.input}); !checked)
    return checked;
  std::optional<double> height;
  if (arguments.height_m > 0) height = arguments.height_m;
  ProgressBar bar;
  Result<SkeletonFile> body = load_body(arguments.input, {pose, {height, {}}, bar.progress()});
  if (!body) return tl::unexpected(body.error());
  Skeleton skeleton = std::move(body->skeleton);
  if (height) {
    Result<Skeleton> scaled = scaled_to_stature(skeleton, *height);
    if (!scaled) return tl::unexpected(scaled.error());
    skeleton = *std::move(scaled);
  }
  if (const auto written = write_body_file(arguments.output, skeleton); !written) return written;
  if (arguments.output != "-")
    std::printf("%s: %d joints, %.2f m tall, legs %.2f m\n", arguments.output.c_str(), skeleton.size(),
                stature(skeleton), skeleton.leg_length());
  return {};
}

}  // namespace

void add_body_command(CLI::App& cli, Action& action) {
  CLI::App* command =
      cli.add_subcommand("body", "Bone lengths and T-pose of the person or skeleton in a source");
  auto arguments = std::make_shared<Arguments>();
  command->add_option("INPUT", arguments->input, "A film, a folder of pictures, a pose file or a motion")
      ->required();
  command
      ->add_option("-o,--output", arguments->output,
                   "The body file to write (.body.json), or - for standard output")
      ->required()
      ->type_name("FILE");
  command->add_option("--height", arguments->height_m, "How tall the person is; scales the body")
      ->check(CLI::Range(0.5, 2.6))
      ->type_name("METRES");
  const auto pose = add_pose_options(*command);
  command->callback(
      [&action, arguments, pose] { action = [arguments, pose] { return run(*arguments, *pose); }; });
}

}  // namespace posecoach
