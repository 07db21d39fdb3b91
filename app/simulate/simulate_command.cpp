#include "app/simulate/simulate_command.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "app/output_check.h"
#include "app/progress_bar.h"
#include "app/simulate/simulate_truth.h"
#include "capture/simulated_source.h"
#include "capture/video_writer.h"
#include "core/base/file.h"

namespace posecoach {
namespace {

struct Options {
  std::string motion = "swing", body = "average", hand = "right", view = "face-on", size = "1280x720";
  std::vector<std::string> faults;
  double fps = 60, length = 1;
  bool list_faults = false;
  std::string output, truth;
};

Result<SimulatedStudentOptions> student_options(const Options& options) {
  SimulatedStudentOptions student;
  student.name = "simulated:" + options.motion;
  std::vector<std::pair<std::string, std::string>> settings = {{"motion", options.motion},
                                                               {"body", options.body},
                                                               {"hand", options.hand},
                                                               {"view", options.view},
                                                               {"size", options.size}};
  for (const std::string& fault : options.faults) settings.emplace_back("fault", fault);
  for (const auto& [key, value] : settings)
    if (auto set = set_simulated_option(student, key, value); !set) return tl::unexpected(set.error());
  student.frames_per_second = options.fps;
  student.length = options.length;
  return student;
}

Result<void> write_film(SimulatedStudent& student, const std::string& path) {
  // Before there is a file to leave behind.
  listen_to_interrupts();
  const FrameSourceInfo& info = student.info();
  auto writer =
      VideoWriter::open(path, {.width = info.width, .height = info.height, .nominal_fps = info.nominal_fps});
  if (!writer) return tl::unexpected(writer.error());
  ProgressBar bar;
  const Progress progress = bar.progress();
  const auto frames = static_cast<double>(*info.frame_count);
  for (;;) {
    const auto frame = student.next({});
    if (!frame) return tl::unexpected(frame.error());
    if (!*frame) return (*writer)->finish();
    if (auto written = (*writer)->write(*(*frame)->image, (*frame)->time); !written) return written;
    if (!report(progress, "filming", static_cast<double>((*frame)->index + 1) / frames))
      return fail(ErrorCode::Cancelled, "stopped; " + path + " was not written");
  }
}

Result<void> simulate(const Options& options, const SimulatedStudentOptions& chosen) {
  if (const Result<void> checked = check_output_files({options.output, options.truth}, {options.body});
      !checked)
    return checked;
  Result<std::unique_ptr<SimulatedStudent>> student = SimulatedStudent::make(chosen);
  if (!student) return tl::unexpected(student.error());
  if (auto written = write_film(**student, options.output); !written) return written;
  if (options.truth.empty()) return {};
  return write_file_atomically(options.truth, truth_as_json(**student, chosen));
}

Result<void> list_faults() {
  std::printf("%s", golf_fault_table().c_str());
  return {};
}

// Wrong settings are wrong usage: found while the command line is read.
Action action_for(const Options& options) {
  if (options.list_faults) return list_faults;
  if (options.output.empty()) throw CLI::RequiredError("--output");
  const Result<SimulatedStudentOptions> chosen = student_options(options);
  if (chosen) return [options, student = *chosen] { return simulate(options, student); };
  if (chosen.error().code == ErrorCode::InvalidArgument)
    throw CLI::ValidationError("simulate", chosen.error().message);
  return [error = chosen.error()]() -> Result<void> { return tl::unexpected(error); };
}

}  // namespace

void add_simulate_command(CLI::App& cli, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      cli.add_subcommand("simulate", "Film of the simulated student, of whom everything is known");
  command->add_option("--motion", options->motion, "What he does")
      ->check(CLI::IsMember({"swing", "putt"}))
      ->capture_default_str();
  command->add_option("--body", options->body, "A body's name, a .body.json or a motion file")
      ->capture_default_str();
  command->add_option("--fault", options->faults,
                      "NAME or NAME=AMOUNT; may be given several times (--list-faults)");
  command
      ->add_option("--length", options->length,
                   "Give the stroke so much of its way: 0.5 is half as long, in the same time")
      ->check(CLI::Range(0.1, 2.0))
      ->capture_default_str();
  command->add_option("--hand", options->hand, "The side he plays from")
      ->check(CLI::IsMember({"right", "left"}))
      ->capture_default_str();
  command
      ->add_option("--view", options->view,
                   "Where the camera stands: face-on or down-the-line, with +20 or -20 behind it that many "
                   "degrees beside it")
      ->capture_default_str();
  command->add_option("--fps", options->fps, "Pictures a second")
      ->check(CLI::Range(1.0, 1000.0))
      ->capture_default_str();
  command->add_option("--size", options->size, "Width and height in pixels, as 720x1280")
      ->capture_default_str();
  command->add_option("-o,--output", options->output, "The film, MP4");
  command->add_option("--truth", options->truth,
                      "JSON with every joint of every frame; - is standard output");
  command->add_flag("--list-faults", options->list_faults, "Show the faults with unit and default, and stop");
  command->callback([options, &action] { action = action_for(*options); });
}

}  // namespace posecoach
