#include "app/retarget_command.h"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/load_motion.h"
#include "app/output_check.h"
#include "app/pose_options.h"
#include "app/progress_bar.h"
#include "core/motion/motion_file.h"
#include "core/retarget/retarget.h"
#include "core/retarget/rotation_recovery.h"
#include "core/retarget/streamed.h"

namespace posecoach {
namespace {

struct Arguments {
  std::string motion, body, output;
  std::string method{to_string(kDefaultRetargetMethod)};
  std::string contacts = "off", limits;
  bool stream = false;
};

void print_summary(const Arguments& arguments, const RetargetResult& result) {
  std::printf("%s: %d frames, bone lengths within %.1e of the body's\n", arguments.output.c_str(),
              result.motion.frame_count(), result.bone_length_error_max);
  if (result.limits.turned_frames > 0)
    std::printf("joint limits: knees or elbows turned back in %d frames, by up to %.1f degrees\n",
                result.limits.turned_frames, result.limits.largest_turn_degrees);
  const ContactReport& contacts = result.contacts;
  if (contacts.grip_frames == 0) return;
  std::printf("grip: %d frames, wrists within %.2f cm (95 %%)", contacts.grip_frames,
              100 * contacts.grip_error_p95_m);
  if (contacts.unreachable_frames.empty())
    std::printf("\n");
  else
    std::printf("; out of reach in %zu frames, by up to %.1f cm\n", contacts.unreachable_frames.size(),
                100 * contacts.reach_deficit_max_m);
}

Result<void> run(const Arguments& arguments, const PoseTrackerOptions& pose) {
  const auto method = retarget_method_from_string(arguments.method);
  if (!method) return tl::unexpected(method.error());
  if (const Result<void> named = check_motion_file_name(arguments.output); !named) return named;
  if (const Result<void> checked = check_output_files({arguments.output}, {arguments.motion, arguments.body});
      !checked)
    return checked;
  ProgressBar bar;
  const LoadOptions options{pose, {}, bar.progress()};
  const Result<SkeletonFile> body = load_body(arguments.body, options);
  if (!body) return tl::unexpected(body.error());
  const Result<LoadedMotion> coach = load_motion(arguments.motion, options);
  if (!coach) return tl::unexpected(coach.error());
  const Contacts contacts = arguments.contacts == "on" ? Contacts::On : Contacts::Off;
  RetargetOptions how{*method, contacts};
  if (!arguments.limits.empty()) how.limits = arguments.limits == "on" ? JointLimits::On : JointLimits::Off;
  const Result<RetargetResult> result = arguments.stream
                                            ? retarget_streamed(coach->motion, body->skeleton, how)
                                            : retarget(coach->motion, body->skeleton, how);
  if (!result)
    return fail(result.error().code,
                arguments.motion + " to " + arguments.body + ": " + result.error().message);
  // A BVH has no place for proportions that are not the body's: there `scale` keeps only its poses.
  const bool needs_rotations = arguments.output.ends_with(".bvh");
  const Motion motion = needs_rotations ? with_rotations(result->motion) : result->motion;
  if (const auto written = write_motion_file(arguments.output, motion, body->provenance); !written)
    return written;
  if (arguments.output != "-") print_summary(arguments, *result);
  return {};
}

}  // namespace

void add_retarget_command(CLI::App& cli, Action& action) {
  CLI::App* command = cli.add_subcommand("retarget", "A coach's motion in another body");
  auto arguments = std::make_shared<Arguments>();
  command->add_option("--motion", arguments->motion, "The coach: a motion file, a film, bundled:swing, ...")
      ->required();
  command->add_option("--body", arguments->body, "The body: a .body.json, or any motion whose body counts")
      ->required();
  command->add_option("-o,--output", arguments->output, "The motion to write: .bvh, .trc or .pose.json")
      ->required()
      ->type_name("FILE");
  command->add_option("--method", arguments->method, "How")
      ->capture_default_str()
      ->check(CLI::IsMember({"rotation", "direction", "scale", "paper", "network"}));
  command->add_option("--contacts", arguments->contacts, "Close the grip and plant the feet")
      ->capture_default_str()
      ->check(CLI::IsMember({"on", "off"}));
  command
      ->add_option("--limits", arguments->limits,
                   "Keep knees and elbows from bending as no human's do; as --contacts unless given")
      ->check(CLI::IsMember({"on", "off"}));
  command->add_flag("--stream", arguments->stream,
                    "Frame by frame, looking back only, as a coach who is still being filmed");
  const auto pose = add_pose_options(*command);
  command->callback([&action, arguments, pose] {
    if (arguments->stream && (arguments->contacts == "on" || arguments->method == "scale"))
      throw CLI::ValidationError(
          "--stream", "has neither contacts, which need the frames that follow, nor the method scale");
    action = [arguments, pose] { return run(*arguments, *pose); };
  });
}

}  // namespace posecoach
