#include "app/evaluate/evaluate_transfer_command.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/output_check.h"
#include "app/transfer/transfer_data.h"
#include "core/base/file.h"
#include "core/motion/bundled_motion.h"
#include "core/transfer/evaluation.h"
#include "core/transfer/trained.h"

namespace posecoach {
namespace {

struct Arguments {
  std::string data, json;
  std::vector<std::string> paper_variants, network_variants;
  std::uint64_t seed = 1;
  std::size_t frames = 120;
};

constexpr std::size_t kSyntheticSamples = 1500, kGripSamples = 600, kFilmPictures = 60, kClipFrames = 300;
constexpr std::array<std::size_t, 2> kPictures = {1, 8};

struct Named {
  std::string name;
  std::unique_ptr<Transferer> transferer;
};

// "NAME=FILE": weights of either network, of another training.
Result<Named> load_variant(const std::string& variant, TransferMethod method) {
  const std::size_t mark = variant.find('=');
  if (mark == std::string::npos)
    return fail(ErrorCode::InvalidArgument, "further weights are given as NAME=FILE, not as " + variant);
  const std::string file = variant.substr(mark + 1);
  const Result<std::string> weights = read_file(file);
  if (!weights) return tl::unexpected(weights.error());
  Result<std::unique_ptr<Transferer>> loaded = load_transferer(method, *weights, file);
  if (!loaded) return tl::unexpected(loaded.error());
  return Named{variant.substr(0, mark), *std::move(loaded)};
}

Result<std::vector<Named>> all_methods(const Arguments& arguments) {
  std::vector<Named> methods;
  for (const TransferMethod method : kTransferMethods) {
    Result<std::unique_ptr<Transferer>> made = make_transferer(method);
    if (!made) return tl::unexpected(made.error());
    methods.push_back({std::string(to_string(method)), *std::move(made)});
  }
  for (const auto& [given, method] : {std::pair{&arguments.paper_variants, TransferMethod::Paper},
                                      std::pair{&arguments.network_variants, TransferMethod::Network}})
    for (const std::string& variant : *given) {
      Result<Named> loaded = load_variant(variant, method);
      if (!loaded) return tl::unexpected(loaded.error());
      methods.push_back(*std::move(loaded));
    }
  return methods;
}

nlohmann::json json_row(const std::string& method, std::size_t pictures, const TransferScore& score) {
  return {{"method", method},
          {"pictures", pictures},
          {"pairs", score.samples},
          {"mse_lengths", score.error.mse_lengths},
          {"mse_angles", score.error.mse_angles},
          {"mse_joints", score.error.mse_joints},
          {"oks_percent", score.error.oks_percent},
          {"violation_percent", score.violations.percent()},
          {"touch_pairs", score.touch_samples},
          {"touch_error", score.touch_error},
          {"touch_error_p95", score.touch_error_p95}};
}

void print_row(const std::string& method, std::size_t pictures, const TransferScore& score) {
  std::printf("%-16s %8zu %7ld %10.5f %9.4f %9.4f %8.2f %10.2f %9.4f\n", method.c_str(), pictures,
              score.samples, score.error.mse_lengths, score.error.mse_angles, score.error.mse_joints,
              score.error.oks_percent, score.violations.percent(), score.touch_error);
  std::fflush(stdout);
}

// One block of Table 2: every method on one set of samples.
nlohmann::json score_all(std::vector<Named>& methods, std::size_t pictures,
                         std::span<const TransferSample> samples, double units, bool prints) {
  nlohmann::json rows = nlohmann::json::array();
  const auto add = [&](const std::string& name, const TransferScore& score) {
    if (prints) print_row(name, pictures, score);
    rows.push_back(json_row(name, pictures, score));
  };
  for (Named& method : methods) add(method.name, score(*method.transferer, samples, units));
  add("bones3d", score_oracle(samples, units));
  return rows;
}

void print_header(const char* title) {
  std::printf("\n%s\n%-16s %8s %7s %10s %9s %9s %8s %10s %9s\n", title, "method", "pictures", "pairs",
              "lengths", "angles", "joints", "OKS %", "flipped %", "touch");
}

nlohmann::json similarity(const std::vector<Character>& characters, std::uint64_t seed, bool prints) {
  nlohmann::json rows = nlohmann::json::array();
  if (prints)
    std::printf(
        "How alike the measures find poses of two people (angles in radians, flipped links in %%)\n"
        "%-9s %7s %7s %7s | 4 directions: bones, +ends, all | 2 directions\n",
        "pairs", "count", "bones", "ends");
  for (const SimilarityRow& row : similarity_table(characters, seed)) {
    const auto percents = [](const std::array<LinkCount, 3>& counts) {
      return std::array{counts[0].percent(), counts[1].percent(), counts[2].percent()};
    };
    const auto four = percents(row.four_directions), two = percents(row.two_directions);
    if (prints)
      std::printf("%-9s %7ld %7.3f %7.3f | %6.2f %6.2f %6.2f | %6.2f %6.2f %6.2f\n", row.pairs.c_str(),
                  row.count, row.angle_rms_bones, row.angle_rms_ends, four[0], four[1], four[2], two[0],
                  two[1], two[2]);
    rows.push_back({{"pairs", row.pairs},
                    {"count", row.count},
                    {"angle_rms_bones", row.angle_rms_bones},
                    {"angle_rms_ends", row.angle_rms_ends},
                    {"violation_percent_4", four},
                    {"violation_percent_2", two}});
  }
  return rows;
}

nlohmann::json over_time(std::vector<Named>& methods, const std::vector<Character>& characters, double units,
                         std::uint64_t seed, bool prints) {
  PairOptions options;
  options.identity_pictures = 8;
  options.seed = seed;
  const auto clips = paired_clips(characters, options, kClipFrames);
  nlohmann::json rows = nlohmann::json::array();
  if (prints)
    std::printf("\nOver time (real pairs, 8 pictures)\n%-16s %7s %16s %8s\n", "method", "clips",
                "squared error", "jitter");
  for (Named& method : methods) {
    ScoreOverTime mean;
    for (const auto& clip : clips) {
      const ScoreOverTime one = score_over_time(*method.transferer, clip, units);
      mean.squared_error += one.squared_error / double(clips.size());
      mean.jitter += one.jitter / double(clips.size());
    }
    if (prints)
      std::printf("%-16s %7zu %16.5f %8.3f\n", method.name.c_str(), clips.size(), mean.squared_error,
                  mean.jitter);
    rows.push_back({{"method", method.name},
                    {"clips", clips.size()},
                    {"squared_error", mean.squared_error},
                    {"jitter", mean.jitter}});
  }
  return rows;
}

void append(nlohmann::json& rows, const nlohmann::json& more) {
  rows.insert(rows.end(), more.begin(), more.end());
}

nlohmann::json real_pairs(std::vector<Named>& methods, const std::vector<Character>& characters,
                          const Arguments& arguments, double units, bool prints) {
  if (prints) print_header("Real pairs");
  nlohmann::json rows = nlohmann::json::array();
  for (const std::size_t pictures : kPictures) {
    PairOptions options;
    options.identity_pictures = pictures;
    options.source_pictures = kFilmPictures;
    options.frames_per_pair = arguments.frames;
    options.seed = arguments.seed;
    append(rows, score_all(methods, pictures, paired_samples(characters, options), units, prints));
  }
  return rows;
}

// Seeds of trainings are small numbers times a million and three; these people are nobody's.
std::vector<TransferSample> samples_of_strangers(const PoseClipPool& pool, std::size_t count,
                                                 std::size_t pictures, std::uint64_t seed) {
  SampleOptions options;
  options.identity_pictures = pictures;
  options.source_pictures = kFilmPictures;
  std::mt19937_64 random(seed + 0x9e3779b97f4a7c15ULL);
  std::vector<TransferSample> samples;
  for (std::size_t i = 0; i < count; ++i) samples.push_back(random_sample(pool, random, options));
  return samples;
}

nlohmann::json synthetic_pairs(std::vector<Named>& methods, const std::vector<Character>& characters,
                               std::uint64_t seed, bool prints) {
  if (prints) print_header("Synthetic people performing the same motions");
  std::vector<PoseClip> clips;
  for (const Character& character : characters)
    for (const PoseClip& clip : character.clips) clips.push_back(clip);
  const PoseClipPool pool(std::move(clips));
  nlohmann::json rows = nlohmann::json::array();
  for (const std::size_t pictures : kPictures) {
    const auto samples = samples_of_strangers(pool, kSyntheticSamples, pictures, seed);
    append(rows, score_all(methods, pictures, samples, units_per_metre(samples), prints));
  }
  return rows;
}

// Hands on one club, on synthetic people: by how much of a stature the wrists' distance changes.
Result<nlohmann::json> golf_grips(std::vector<Named>& methods, std::uint64_t seed, bool prints) {
  std::vector<PoseClip> clips;
  for (const std::string& name : bundled_motion_names()) {
    const Result<Motion> motion = bundled_motion(name);
    if (!motion) return tl::unexpected(motion.error());
    Result<PoseClip> clip = make_pose_clip(name, *motion);
    if (!clip) return tl::unexpected(clip.error());
    clips.push_back(*std::move(clip));
  }
  const PoseClipPool pool(std::move(clips));
  if (prints)
    std::printf(
        "\nGolf grips (the program's own strokes, synthetic people): change of the wrists' distance, "
        "in statures\n%-16s %8s %7s %9s %9s\n",
        "method", "pictures", "pairs", "mean", "95 %");
  nlohmann::json rows = nlohmann::json::array();
  for (const std::size_t pictures : kPictures) {
    const auto samples = samples_of_strangers(pool, kGripSamples, pictures, seed);
    for (Named& method : methods) {
      const TransferScore one = score(*method.transferer, samples);
      if (prints)
        std::printf("%-16s %8zu %7ld %9.4f %9.4f\n", method.name.c_str(), pictures, one.touch_samples,
                    one.touch_error, one.touch_error_p95);
      rows.push_back({{"method", method.name},
                      {"pictures", pictures},
                      {"touch_pairs", one.touch_samples},
                      {"touch_error", one.touch_error},
                      {"touch_error_p95", one.touch_error_p95}});
    }
  }
  return rows;
}

Result<void> run(const Arguments& arguments) {
  if (const Result<void> checked = check_output_files({arguments.json}, {}); !checked) return checked;
  const Result<std::vector<Character>> characters = read_characters(arguments.data);
  if (!characters) return tl::unexpected(characters.error());
  Result<std::vector<Named>> methods = all_methods(arguments);
  if (!methods) return tl::unexpected(methods.error());
  const bool prints = arguments.json != "-";
  const double units = units_per_metre(*characters);
  nlohmann::json answer = {
      {"schema", "posecoach.evaluate/1"}, {"task", "transfer"}, {"units_per_metre", units}};
  answer["similarity"] = similarity(*characters, arguments.seed, prints);
  answer["rows"] = real_pairs(*methods, *characters, arguments, units, prints);
  answer["synthetic"] = synthetic_pairs(*methods, *characters, arguments.seed, prints);
  Result<nlohmann::json> grips = golf_grips(*methods, arguments.seed, prints);
  if (!grips) return tl::unexpected(grips.error());
  answer["grips"] = *std::move(grips);
  answer["over_time"] = over_time(*methods, *characters, units, arguments.seed, prints);
  return arguments.json.empty() ? Result<void>()
                                : write_file_atomically(arguments.json, answer.dump(1) + "\n");
}

}  // namespace

void add_evaluate_transfer_command(CLI::App& evaluate, Action& action) {
  CLI::App* command =
      evaluate.add_subcommand("transfer", "The 2D pose transfer against real and synthetic pairs");
  auto arguments = std::make_shared<Arguments>();
  command
      ->add_option("--data", arguments->data, "Folder of CHARACTER/MOTION.bvh; equal names are equal motions")
      ->required()
      ->type_name("DIR");
  command->add_option("--json", arguments->json, "Write the tables as JSON; - for standard output")
      ->type_name("FILE");
  command
      ->add_option("--paper", arguments->paper_variants, "Further weights of the paper's network to compare")
      ->type_name("NAME=FILE");
  command->add_option("--network", arguments->network_variants, "Further weights of ours")
      ->type_name("NAME=FILE");
  command->add_option("--frames", arguments->frames, "Poses of each pair of characters and motion")
      ->capture_default_str()
      ->check(CLI::PositiveNumber)
      ->type_name("N");
  command->add_option("--seed", arguments->seed, "Of poses and views")->capture_default_str()->type_name("N");
  command->callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace posecoach
