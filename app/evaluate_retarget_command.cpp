#include "app/evaluate_retarget_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/progress_bar.h"
#include "core/base/file.h"
#include "core/motion/motion_file.h"
#include "core/retarget/evaluation.h"

namespace posecoach {
namespace fs = std::filesystem;

namespace {

struct Arguments {
  std::string data, json;
  std::string rotations = "file";
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

const char* to_string(Contacts contacts) {
  return contacts == Contacts::On ? "on" : "off";
}

void print(const Evaluation& evaluation) {
  for (const std::string& note : evaluation.notes) std::printf("%s\n", note.c_str());
  std::printf("\nCode metric: mean over frames, joints and x, y, z of the squared difference / h^2.\n");
  std::printf("%-10s %-9s %-6s %-8s %5s %9s %9s %9s %9s %9s %8s %10s %9s\n", "method", "structure", "input",
              "contacts", "pairs", "root", "local", "global", "eq16 cm", "bones", "grip cm", "slide cm/s",
              "jitter");
  for (const EvaluationRow& row : evaluation.rows) {
    const PairErrors& mean = row.mean;
    std::printf("%-10s %-9s %-6s %-8s %5d %9.2e %9.2e %9.2e %9.3f %9.1e ",
                std::string(to_string(row.method)).c_str(), to_string(row.structure), "clean",
                to_string(row.contacts), row.pairs, mean.root, mean.local, mean.global, mean.eq16_cm,
                mean.bone_length);
    if (mean.grip_cm)
      std::printf("%8.2f ", *mean.grip_cm);
    else
      std::printf("%8s ", "-");
    std::printf("%10.2f %9.1f\n", mean.slide_cm_s, mean.jitter_m_s3);
  }
}

std::string json_of(const Evaluation& evaluation) {
  nlohmann::ordered_json answer = {
      {"schema", "posecoach.evaluate/1"}, {"task", "retarget"}, {"rows", nlohmann::json::array()}};
  for (const EvaluationRow& row : evaluation.rows) {
    const PairErrors& mean = row.mean;
    nlohmann::ordered_json entry = {{"method", to_string(row.method)},
                                    {"structure", to_string(row.structure)},
                                    {"input", "clean"},
                                    {"contacts", to_string(row.contacts)},
                                    {"pairs", row.pairs},
                                    {"root", mean.root},
                                    {"local", mean.local},
                                    {"global", mean.global},
                                    {"eq16", mean.eq16_cm},
                                    {"bone_length_error", mean.bone_length}};
    entry["grip_cm"] = mean.grip_cm ? nlohmann::json(*mean.grip_cm) : nlohmann::json();
    entry["slide_cm_s"] = mean.slide_cm_s;
    entry["jitter"] = mean.jitter_m_s3;
    answer["rows"].push_back(std::move(entry));
  }
  answer["notes"] = evaluation.notes;
  return answer.dump(1) + "\n";
}

Result<void> run(const Arguments& arguments) {
  const auto motions = read_characters(arguments.data);
  if (!motions) return tl::unexpected(motions.error());
  ProgressBar bar;
  const auto evaluation = evaluate_retarget(
      *motions, arguments.rotations == "file" ? RotationSource::FileFirst : RotationSource::Positions,
      bar.progress());
  if (!evaluation) return tl::unexpected(evaluation.error());
  if (arguments.json != "-") print(*evaluation);
  return arguments.json.empty() ? Result<void>()
                                : write_file_atomically(arguments.json, json_of(*evaluation));
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
  command->add_option("--json", arguments->json, "Write the table as JSON; - for standard output")
      ->type_name("FILE");
  command->callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace posecoach
