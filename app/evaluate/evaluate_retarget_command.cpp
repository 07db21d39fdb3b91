#include "app/evaluate/evaluate_retarget_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/progress_bar.h"
#include "core/base/file.h"
#include "core/body/standard_body.h"
#include "core/motion/bundled_motion.h"
#include "core/motion/motion_file.h"
#include "core/retarget/experiments.h"

namespace posecoach {
namespace fs = std::filesystem;

namespace {

struct Arguments {
  std::string data, json;
  std::string rotations = "file", noise = "both";
  std::vector<std::string> paper_weights, golf;
  bool pairs = false;
};

Result<std::vector<fs::path>> entries_of(const fs::path& folder) {
  std::error_code reason;
  std::vector<fs::path> entries;
  for (fs::directory_iterator entry(folder, reason), end; !reason && entry != end; entry.increment(reason))
    entries.push_back(entry->path());
  if (reason)
    return fail(ErrorCode::NotFound, "cannot read the folder " + folder.string() + ": " + reason.message());
  std::sort(entries.begin(), entries.end());
  return entries;
}

Result<std::vector<CharacterMotion>> read_characters(const fs::path& data) {
  const auto characters = entries_of(data);
  if (!characters) return tl::unexpected(characters.error());
  std::vector<CharacterMotion> motions;
  for (const fs::path& character : *characters) {
    std::error_code ignored;
    if (!fs::is_directory(character, ignored)) continue;
    const auto files = entries_of(character);
    if (!files) return tl::unexpected(files.error());
    for (const fs::path& file : *files) {
      if (file.extension() != ".bvh") continue;
      Result<MotionFile> read = read_motion_file(file);
      if (!read) return tl::unexpected(read.error());
      motions.push_back({character.filename().string(), file.stem().string(), std::move(read->motion)});
    }
  }
  if (motions.empty())
    return fail(ErrorCode::Incomplete, data.string() + ": there is no <character>/<motion>.bvh in it");
  return motions;
}

const char* to_string(Structure structure) {
  return structure == Structure::Intra ? "intra" : "cross";
}

const char* to_string(EvaluationInput input) {
  return input == EvaluationInput::Webcam ? "webcam" : "clean";
}

const char* to_string(Contacts contacts) {
  return contacts == Contacts::On ? "on" : "off";
}

void print_errors(const PairErrors& errors) {
  std::printf("%9.2e %9.2e %9.2e %9.3f %9.1e ", errors.root, errors.local, errors.global, errors.eq16_cm,
              errors.bone_length);
  if (errors.grip_cm)
    std::printf("%8.2f ", *errors.grip_cm);
  else
    std::printf("%8s ", "-");
  std::printf("%10.2f %8.1f %9.1f", errors.slide_cm_s, errors.beyond_limits_degrees, errors.jitter_m_s3);
}

void print(const Evaluation& evaluation, bool pairs) {
  for (const std::string& note : evaluation.notes) std::printf("%s\n", note.c_str());
  std::printf("\nCode metric: mean over frames, joints and x, y, z of the squared difference / h^2.\n");
  std::printf("%-22s %-9s %-6s %-8s %5s %9s %9s %9s %9s %9s %8s %10s %8s %9s\n", "method", "structure",
              "input", "contacts", "pairs", "root", "local", "global", "eq16 cm", "bones", "grip cm",
              "slide cm/s", "limits o", "jitter");
  for (const EvaluationRow& row : evaluation.rows) {
    std::printf("%-22s %-9s %-6s %-8s %5d ", row.method.c_str(), to_string(row.structure),
                to_string(row.input), to_string(row.contacts), row.pairs);
    print_errors(row.mean);
    std::printf("\n");
  }
  for (const EvaluatedPair& pair : evaluation.pairs) {
    if (!pairs) break;
    std::printf("%-22s %-9s %-6s %-8s %5s ", pair.method.c_str(), to_string(pair.structure),
                to_string(pair.input), to_string(pair.contacts), "");
    print_errors(pair.errors);
    std::printf("  %s: %s to %s\n", pair.motion.c_str(), pair.coach.c_str(), pair.student.c_str());
  }
}

void print(const std::vector<GripRow>& grips, const std::vector<HistoryRow>& histories) {
  std::printf("\nGrip, network with contacts, wrists from each other as the coach's:\n");
  std::printf("%-14s %-28s %9s %8s %10s %12s %10s %10s\n", "motion", "body", "before cm", "95 % cm",
              "deficit cm", "unreachable", "slide cm/s", "coach's");
  for (const GripRow& row : grips)
    std::printf("%-14s %-28s %9.2f %8.3f %10.2f %5d of %4d %10.2f %10.2f\n", row.motion.c_str(),
                row.body.c_str(), row.before_cm, row.p95_cm, row.deficit_cm, row.unreachable, row.frames,
                row.slide_cm_s, row.coach_slide_cm_s);
  std::printf("\nOne pose, two histories of rotations (every bone spun by a quarter turn), results apart:\n");
  for (const HistoryRow& row : histories)
    std::printf("%-28s mean %6.2f cm, at most %6.2f cm\n", row.method.c_str(), row.mean_cm, row.max_cm);
}

nlohmann::ordered_json json_of(const PairErrors& errors) {
  return {{"root", errors.root},
          {"local", errors.local},
          {"global", errors.global},
          {"eq16", errors.eq16_cm},
          {"bone_length_error", errors.bone_length},
          {"grip_cm", errors.grip_cm ? nlohmann::json(*errors.grip_cm) : nlohmann::json()},
          {"slide_cm_s", errors.slide_cm_s},
          {"coach_slide_cm_s", errors.coach_slide_cm_s},
          {"beyond_limits_degrees", errors.beyond_limits_degrees},
          {"jitter", errors.jitter_m_s3}};
}

std::string json_of(const Evaluation& evaluation, const std::vector<GripRow>& grips,
                    const std::vector<HistoryRow>& histories) {
  nlohmann::ordered_json answer = {
      {"schema", "posecoach.evaluate/1"}, {"task", "retarget"}, {"rows", nlohmann::json::array()}};
  for (const EvaluationRow& row : evaluation.rows) {
    nlohmann::ordered_json entry = {{"method", row.method},
                                    {"structure", to_string(row.structure)},
                                    {"input", to_string(row.input)},
                                    {"contacts", to_string(row.contacts)},
                                    {"pairs", row.pairs}};
    entry.update(json_of(row.mean));
    answer["rows"].push_back(std::move(entry));
  }
  answer["pairs"] = nlohmann::json::array();
  for (const EvaluatedPair& pair : evaluation.pairs) {
    nlohmann::ordered_json entry = {
        {"method", pair.method},          {"structure", to_string(pair.structure)},
        {"input", to_string(pair.input)}, {"contacts", to_string(pair.contacts)},
        {"motion", pair.motion},          {"coach", pair.coach},
        {"student", pair.student}};
    entry.update(json_of(pair.errors));
    answer["pairs"].push_back(std::move(entry));
  }
  for (const GripRow& row : grips)
    answer["grip"].push_back({{"motion", row.motion},
                              {"body", row.body},
                              {"before_cm", row.before_cm},
                              {"p95_cm", row.p95_cm},
                              {"deficit_cm", row.deficit_cm},
                              {"unreachable_frames", row.unreachable},
                              {"frames", row.frames},
                              {"slide_cm_s", row.slide_cm_s},
                              {"coach_slide_cm_s", row.coach_slide_cm_s}});
  for (const HistoryRow& row : histories)
    answer["histories"].push_back({{"method", row.method}, {"mean_cm", row.mean_cm}, {"max_cm", row.max_cm}});
  answer["notes"] = evaluation.notes;
  return answer.dump(1) + "\n";
}

Result<std::vector<CharacterMotion>> golf_motions(const std::vector<std::string>& files) {
  std::vector<CharacterMotion> golf;
  for (const std::string& name : bundled_motion_names()) {
    Result<Motion> motion = bundled_motion(name);
    if (!motion) return tl::unexpected(motion.error());
    golf.push_back({"bundled", name, resample(*motion, 30)});
  }
  for (const std::string& file : files) {
    Result<MotionFile> read = read_motion_file(file);
    if (!read) return tl::unexpected(read.error());
    golf.push_back({"", fs::path(file).stem().string(), resample(read->motion, 30)});
  }
  return golf;
}

// The rotations of one file are the histories of the other.
Result<std::vector<HistoryRow>> histories_of(const std::vector<EvaluatedMethod>& methods) {
  const Result<Motion> swing = bundled_motion("swing");
  if (!swing) return tl::unexpected(swing.error());
  std::vector<EvaluatedMethod> asked;
  for (const EvaluatedMethod& method : methods) {
    const bool reads_rotations = method.options.method == RetargetMethod::Rotation ||
                                 method.options.method == RetargetMethod::Direction ||
                                 method.options.method == RetargetMethod::Network;
    asked.push_back(method);
    if (!reads_rotations) continue;
    asked.back().name += ", rotations of the file";
    asked.push_back(method);
    asked.back().name += ", positions";
    asked.back().options.rotations = RotationSource::Positions;
  }
  const Skeleton body =
      with_sloped_limbs(make_standard_body({.height_m = 1.6, .arms = 1.15, .shoulders = 0.9}), 0.15);
  return part_by_history(resample(*swing, 30), body, asked);
}

Result<void> run(const Arguments& arguments) {
  const auto motions = read_characters(arguments.data);
  if (!motions) return tl::unexpected(motions.error());
  EvaluationOptions options;
  options.rotations = arguments.rotations == "file" ? RotationSource::FileFirst : RotationSource::Positions;
  options.inputs.clear();
  if (arguments.noise != "webcam") options.inputs.push_back(EvaluationInput::Clean);
  if (arguments.noise != "none") options.inputs.push_back(EvaluationInput::Webcam);
  for (const std::string& file : arguments.paper_weights) {
    EvaluatedMethod& method = options.methods.emplace_back();
    method.name = "paper:" + fs::path(file).stem().string();
    method.options.method = RetargetMethod::Paper;
    method.options.paper_weights = file;
  }
  ProgressBar bar;
  const auto evaluation = evaluate_retarget(*motions, options, bar.progress());
  if (!evaluation) return tl::unexpected(evaluation.error());
  const auto golf = golf_motions(arguments.golf);
  if (!golf) return tl::unexpected(golf.error());
  const auto grips = grips_on_other_bodies(*golf, options.methods.front());
  if (!grips) return tl::unexpected(grips.error());
  const auto histories = histories_of(options.methods);
  if (!histories) return tl::unexpected(histories.error());
  if (arguments.json != "-") {
    print(*evaluation, arguments.pairs);
    print(*grips, *histories);
  }
  return arguments.json.empty()
             ? Result<void>()
             : write_file_atomically(arguments.json, json_of(*evaluation, *grips, *histories));
}

}  // namespace

void add_evaluate_retarget_command(CLI::App& evaluate, Action& action) {
  CLI::App* command = evaluate.add_subcommand(
      "retarget", "Retargeted motions against what the other character really did, every method");
  auto arguments = std::make_shared<Arguments>();
  command
      ->add_option("--data", arguments->data,
                   "Folder with <character>/<motion>.bvh; the same name is the same motion, frame by frame")
      ->required()
      ->type_name("DIR");
  command
      ->add_option("--rotations", arguments->rotations,
                   "Use the files' rotations, or recover them from positions alone")
      ->capture_default_str()
      ->check(CLI::IsMember({"file", "positions"}));
  command
      ->add_option("--noise", arguments->noise,
                   "Give every method the coach as he is, or as a webcam would see him")
      ->capture_default_str()
      ->check(CLI::IsMember({"none", "webcam", "both"}));
  command
      ->add_option("--paper-weights", arguments->paper_weights,
                   "More networks of the paper's kind, as `train retarget` writes them")
      ->type_name("FILE");
  command->add_option("--golf", arguments->golf, "More golf motions for the grip on other bodies")
      ->type_name("FILE");
  command->add_flag("--pairs", arguments->pairs, "Print every pair, not only the means");
  command->add_option("--json", arguments->json, "Write the table as JSON; - for standard output")
      ->type_name("FILE");
  command->callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace posecoach
