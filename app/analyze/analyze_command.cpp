#include "app/analyze/analyze_command.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/analyze/analyze_outputs.h"
#include "app/analyze/picture_retarget.h"
#include "app/load_motion.h"
#include "app/pose_options.h"
#include "app/progress_bar.h"
#include "core/body/landmark_body.h"
#include "core/coaching/summary.h"

namespace posecoach {
namespace {

struct Arguments {
  std::string coach, student, body, method = std::string(to_string(kDefaultRetargetMethod)), hand = "auto",
                                    contacts = "on", strictness;
  std::optional<double> height_m;
  AnalyzeOutputs outputs;
};

// What is known of the coach: a motion, or, carried over from picture to picture, only what was seen.
struct Coach {
  std::optional<LoadedMotion> motion;
  std::optional<PoseTrack> pictures;
};

Result<Coach> load_coach(const Arguments& arguments, const LoadOptions& load) {
  if (arguments.method == kTransfer2d) {
    Result<PoseTrack> pictures = load_coach_pictures(arguments.coach, load);
    if (!pictures) return tl::unexpected(pictures.error());
    return Coach{std::nullopt, *std::move(pictures)};
  }
  Result<LoadedMotion> motion = load_motion(arguments.coach, load);
  if (!motion) return tl::unexpected(motion.error());
  return Coach{*std::move(motion), std::nullopt};
}

Result<AnalyzeOptions> analyze_options(const Arguments& arguments) {
  AnalyzeOptions options;
  if (arguments.hand != "auto")
    options.hand = arguments.hand == "left" ? Handedness::Left : Handedness::Right;
  if (arguments.method != kTransfer2d) {
    const Result<RetargetMethod> method = retarget_method_from_string(arguments.method);
    if (!method) return tl::unexpected(method.error());
    options.retarget.method = *method;
  }
  const Result<Strictness> strictness = Strictness::parse(arguments.strictness);
  if (!strictness) return tl::unexpected(strictness.error());
  options.strictness = *strictness;
  options.retarget.contacts = arguments.contacts == "on" ? Contacts::On : Contacts::Off;
  return options;
}

StudentInput student_input(const LoadedMotion& student, const std::optional<Skeleton>& body) {
  StudentInput input =
      student.student ? student_from_film(student.source, student.student->track, student.student->lifted)
                      : student_from_motion(student.source, student.motion);
  if (body) input.body = *body;
  return input;
}

Result<void> run(const Arguments& arguments, const PoseTrackerOptions& pose) {
  const Result<AnalyzeOptions> options = analyze_options(arguments);
  if (!options) return tl::unexpected(options.error());
  if (const Result<void> checked =
          check_outputs(arguments.outputs, {arguments.coach, arguments.student, arguments.body});
      !checked)
    return checked;
  listen_to_interrupts();
  ProgressBar bar;
  LoadOptions load{pose, {}, bar.progress()};
  const Result<Coach> coach = load_coach(arguments, load);
  if (!coach) return tl::unexpected(coach.error());
  std::optional<Skeleton> body;
  load.lift.height_m = arguments.height_m;
  if (!arguments.body.empty()) {
    Result<SkeletonFile> file = load_body(arguments.body, load);
    if (!file) return tl::unexpected(file.error());
    body = std::move(file->skeleton);
    // A webcam body was measured before: the film's metres follow it.
    if (is_landmark_body(*body)) load.lift.body = body;
  }
  const Result<LoadedMotion> student = load_motion(arguments.student, load);
  if (!student) return tl::unexpected(student.error());
  const Result<AnalyzedPair> pair =
      coach->pictures
          ? analyze_in_picture(*coach->pictures, *student, *options)
          : analyze(student_input(*student, body), {coach->motion->source, coach->motion->motion}, *options);
  if (!pair) return tl::unexpected(pair.error());
  if (const Result<void> written = write_outputs(arguments.outputs, *student, *pair, bar.progress());
      !written)
    return written;
  // Standard output belongs to the JSON or the page when they were asked for there.
  const bool is_taken = arguments.outputs.json == "-" || arguments.outputs.report == "-";
  const std::string lines = summary(pair->analysis);
  std::fputs(lines.c_str(), is_taken ? stderr : stdout);
  return {};
}

}  // namespace

void add_analyze_command(CLI::App& cli, Action& action) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      cli.add_subcommand("analyze", "A student's swing against the coach's, in the student's own body");
  command
      ->add_option("--coach", arguments->coach,
                   "The coach: a film, a motion file, bundled:swing, bundled:putt")
      ->required();
  command->add_option("--student", arguments->student, "The student: a film or a motion file")->required();
  command->add_option("--body", arguments->body,
                      "The student's body, .body.json or any motion; measured when not given");
  command->add_option("--retarget", arguments->method, "How the coach gets into the student's body")
      ->capture_default_str()
      ->check(CLI::IsMember({"rotation", "direction", "scale", "paper", "network", kTransfer2d}));
  command->add_option("--hand", arguments->hand, "The side that the student plays from")
      ->capture_default_str()
      ->check(CLI::IsMember({"left", "right", "auto"}));
  command
      ->add_option("--contacts", arguments->contacts,
                   "Close the grip and plant the feet of the coach's motion")
      ->capture_default_str()
      ->check(CLI::IsMember({"on", "off"}));
  command
      ->add_option("--strictness", arguments->strictness,
                   "How hard parts are judged, as arms=2,legs=0: 2 tells half the difference, 0 none")
      ->type_name("PART=N,...");
  command->add_option("--height", arguments->height_m, "The student's height, for films")
      ->check(CLI::Range(0.5, 2.6))
      ->type_name("METRES");
  command->add_option("--json", arguments->outputs.json, "Write the analysis; - is standard output")
      ->type_name("FILE");
  command->add_option("--report", arguments->outputs.report, "Write a page with pictures, for any browser")
      ->type_name("FILE.html");
  command->add_option("--video", arguments->outputs.video, "Write the film with both skeletons drawn over it")
      ->type_name("FILE.mp4");
  command
      ->add_option_function<std::string>(
          "--palette",
          [arguments](const std::string& name) {
            arguments->outputs.palette =
                name == "colour-blind" ? Palette::ColourBlindSafe : Palette::RedGreen;
          },
          "Colours of the report and the film: red-green (default) or colour-blind")
      ->check(CLI::IsMember({"red-green", "colour-blind"}))
      ->type_name("NAME");
  const auto pose = add_pose_options(*command);
  command->callback(
      [&action, arguments, pose] { action = [arguments, pose] { return run(*arguments, *pose); }; });
}

}  // namespace posecoach
