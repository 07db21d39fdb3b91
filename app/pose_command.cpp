#include "app/pose_command.h"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/output_check.h"
#include "app/pose_options.h"
#include "app/progress_bar.h"
#include "capture/open_source.h"
#include "core/base/log.h"
#include "core/motion/pose_file.h"
#include "core/pipeline/track_poses.h"

namespace posecoach {
namespace {

Result<void> write_poses(const std::string& input, const std::string& output,
                         const PoseTrackerOptions& options) {
  if (const Result<void> checked = check_output_files({output}, {input}); !checked) return checked;
  ProgressBar bar;
  auto source = open_source(input);
  if (!source) return tl::unexpected(source.error());
  auto tracker = PoseTracker::make(options);
  if (!tracker) return tl::unexpected(tracker.error());
  const FrameSourceInfo& info = (*source)->info();
  auto file = PoseTrackWriter::create(output, info.name, info.width, info.height);
  if (!file) return tl::unexpected(file.error());
  const auto done = track_poses(**source, **tracker, bar.progress(),
                                [&](const PoseObservation& seen) { return file->add(seen); });
  if (!done) return tl::unexpected(done.error());
  if (done->frames_with_person == 0) log::warning("nobody is seen in " + input);
  return file->finish();
}

}  // namespace

void add_pose_command(CLI::App& cli, Action& action) {
  CLI::App* command = cli.add_subcommand("pose", "2D and 3D joints of the person in every frame");
  auto input = std::make_shared<std::string>();
  auto output = std::make_shared<std::string>();
  command->add_option("INPUT", *input, "A film, a folder of pictures, or simulated:swing, simulated:putt")
      ->required();
  command->add_option("-o,--output", *output, "The pose file to write (.pose.json), or - for standard output")
      ->required()
      ->type_name("FILE");
  const auto options = add_pose_options(*command);
  command->add_flag_callback(
      "--detect-every-frame", [options] { options->search = Search::InEveryFrame; },
      "Look for the person anew in every frame, without tracking and smoothing");
  command->add_flag_callback(
      "--no-smoothing", [options] { options->smoothing = Smoothing::Off; },
      "Leave the joints as the network gives them");
  command->callback([&action, input, output, options] {
    action = [input, output, options] { return write_poses(*input, *output, *options); };
  });
}

}  // namespace posecoach
