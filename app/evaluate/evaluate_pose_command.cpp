#include "app/evaluate/evaluate_pose_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/evaluate/pose_reference.h"
#include "app/progress_bar.h"
#include "capture/open_source.h"
#include "core/base/file.h"
#include "core/pipeline/track_poses.h"

namespace posecoach {
namespace fs = std::filesystem;

namespace {

struct Arguments {
  std::string data;
  std::string film;
  std::string models;
  std::string json;
};

Result<std::vector<fs::path>> files_in(const fs::path& folder) {
  std::error_code reason;
  std::vector<fs::path> files;
  for (fs::directory_iterator entry(folder, reason), end; !reason && entry != end; entry.increment(reason))
    files.push_back(entry->path());
  if (reason)
    return fail(ErrorCode::NotFound, "cannot read the folder " + folder.string() + ": " + reason.message());
  std::sort(files.begin(), files.end());
  return files;
}

Result<fs::path> find_film(const Arguments& arguments) {
  if (!arguments.film.empty()) return fs::path(arguments.film);
  const auto films = files_in(fs::path(arguments.data) / "video");
  if (!films) return tl::unexpected(films.error());
  if (films->size() == 1) return films->front();
  return fail(ErrorCode::InvalidArgument,
              arguments.data + "/video must hold exactly one film; name another with --film");
}

void print_row(const PoseReference& reference, const PoseAgreement& row) {
  std::printf("%-28s %8zu %10zu %12.4f %9.4f %9.4f %14.4f\n", reference.name.c_str(), row.frames,
              row.mismatched, row.image_median_px, row.image_percentile95_px, row.image_max_px,
              row.world_median_mm);
  std::fflush(stdout);
}

nlohmann::json json_row(const PoseReference& reference, const PoseAgreement& row) {
  return {{"reference", reference.name},
          {"frames", row.frames},
          {"mismatched", row.mismatched},
          {"image_median_px", row.image_median_px},
          {"image_p95_px", row.image_percentile95_px},
          {"image_max_px", row.image_max_px},
          {"world_median_mm", row.world_median_mm}};
}

Result<PoseAgreement> evaluate(const PoseReference& reference, const fs::path& film,
                               const std::string& models) {
  PoseTrackerOptions options = reference.options;
  if (!models.empty()) options.models = models;
  auto tracker = PoseTracker::make(options);
  if (!tracker) return tl::unexpected(tracker.error());
  auto source = open_source(film.string());
  if (!source) return tl::unexpected(source.error());
  ProgressBar bar;
  const auto track = track_poses(**source, **tracker, bar.progress());
  if (!track) return tl::unexpected(track.error());
  return compare_poses(*track, reference);
}

Result<void> run(const Arguments& arguments) {
  const auto film = find_film(arguments);
  if (!film) return tl::unexpected(film.error());
  const auto files = files_in(fs::path(arguments.data) / "reference");
  if (!files) return tl::unexpected(files.error());
  nlohmann::json answer = {
      {"schema", "posecoach.evaluate/1"}, {"task", "pose"}, {"rows", nlohmann::json::array()}};
  const bool prints = arguments.json != "-";
  if (prints)
    std::printf("%-28s %8s %10s %12s %9s %9s %14s\n", "reference", "frames", "mismatched", "2D median px",
                "95 % px", "max px", "world median mm");
  for (const fs::path& file : *files) {
    if (file.extension() != ".json") continue;
    const auto reference = read_pose_reference(file);
    if (!reference) return tl::unexpected(reference.error());
    const auto row = evaluate(*reference, *film, arguments.models);
    if (!row) return tl::unexpected(row.error());
    if (prints) print_row(*reference, *row);
    answer["rows"].push_back(json_row(*reference, *row));
  }
  if (answer["rows"].empty())
    return fail(ErrorCode::Incomplete, "there are no references (.json) in " + arguments.data + "/reference");
  if (arguments.json.empty()) return {};
  return write_file_atomically(arguments.json, answer.dump(1) + "\n");
}

}  // namespace

void add_evaluate_pose_command(CLI::App& evaluate_command, Action& action) {
  CLI::App* command =
      evaluate_command.add_subcommand("pose", "The pose stage against another program's answers");
  auto arguments = std::make_shared<Arguments>();
  command->add_option("--data", arguments->data, "Folder with video/ (one film) and reference/ (*.json)")
      ->required()
      ->type_name("DIR");
  command->add_option("--film", arguments->film, "The film that the references are for")->type_name("FILE");
  command->add_option("--models", arguments->models, "Folder of the pose networks")->type_name("DIR");
  command->add_option("--json", arguments->json, "Write the table as JSON; - for standard output")
      ->type_name("FILE");
  command->callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace posecoach
