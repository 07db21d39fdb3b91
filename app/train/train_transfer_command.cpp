#include "app/train/train_transfer_command.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <limits>
#include <map>

#include "app/output_check.h"
#include "app/progress_bar.h"
#include "app/transfer/transfer_data.h"
#include "core/transfer/training.h"

namespace posecoach {
namespace {

struct Arguments {
  std::string data;
  std::string method = "network";
  TransferTrainingOptions options;
  PaperTransferVariant variant;
  double turn_degrees = 0;
  bool minutes_given = false;
};

const std::map<std::string, TransferPoseLoss> kLosses = {{"none", TransferPoseLoss::None},
                                                         {"ranking", TransferPoseLoss::Ranking},
                                                         {"vl", TransferPoseLoss::VirtualLinks},
                                                         {"al", TransferPoseLoss::Angles},
                                                         {"vl+al", TransferPoseLoss::VirtualLinksAndAngles}};
const std::map<std::string, Links> kLinks = {
    {"bones", Links::Bones}, {"bones+ends", Links::BonesAndEnds}, {"all", Links::All}};

Result<void> run(Arguments& arguments) {
  if (const Result<void> checked = check_output_files({arguments.options.weights.string()}, {}); !checked)
    return checked;
  Result<std::vector<PoseClip>> clips = read_training_clips(arguments.data);
  if (!clips) return tl::unexpected(clips.error());
  ProgressBar bar;
  TransferTrainingOptions& options = arguments.options;
  options.progress = bar.progress();
  // Iterations alone mean: however long they take.
  if (options.iterations > 0 && !arguments.minutes_given)
    options.minutes = std::numeric_limits<double>::max();
  arguments.variant.directions_turned = radians_from_degrees(arguments.turn_degrees);
  const Result<TransferTrainingSummary> summary =
      arguments.method == "paper" ? train_paper_transfer(*std::move(clips), options, arguments.variant)
                                  : train_network_transfer(*std::move(clips), options);
  if (!summary) return tl::unexpected(summary.error());
  std::printf(
      "%ld iterations in %.1f minutes; the weights kept are those of iteration %ld, OKS %.2f %% on held-out "
      "people\n",
      summary->iterations, summary->minutes, summary->best_iteration, summary->best_score);
  if (summary->stopped) std::printf("stopped; --resume goes on\n");
  return {};
}

}  // namespace

void add_train_transfer_command(CLI::App& train, Action& action) {
  CLI::App* command = train.add_subcommand("transfer", "The networks of the 2D pose transfer");
  auto arguments = std::make_shared<Arguments>();
  command->add_option("--data", arguments->data, "Folder of 3D motions; folders named paired are left out")
      ->required()
      ->type_name("DIR");
  command
      ->add_option("-o,--output", arguments->options.weights,
                   "The weights to write; beside them .csv, .png (the log) and .checkpoint")
      ->required()
      ->type_name("FILE");
  command->add_option("--method", arguments->method, "network (ours) or paper")
      ->capture_default_str()
      ->check(CLI::IsMember({"network", "paper"}))
      ->type_name("NAME");
  CLI::Option* minutes = command->add_option("--minutes", arguments->options.minutes, "How long")
                             ->capture_default_str()
                             ->check(CLI::PositiveNumber)
                             ->type_name("N");
  command->add_option("--iterations", arguments->options.iterations, "How many updates at the most")
      ->check(CLI::PositiveNumber)
      ->type_name("N");
  command->add_flag("--resume", arguments->options.resume, "Go on from the checkpoint beside the weights");
  command->add_option("--seed", arguments->options.seed, "Of everything random")
      ->capture_default_str()
      ->type_name("N");
  command
      ->add_option("--loss", arguments->variant.loss,
                   "Pose loss of the paper's network: none, ranking, vl, al, vl+al")
      ->transform(CLI::CheckedTransformer(kLosses))
      ->type_name("NAME");
  command->add_option("--links", arguments->variant.links, "Its virtual links: bones, bones+ends, all")
      ->transform(CLI::CheckedTransformer(kLinks))
      ->type_name("NAME");
  command
      ->add_option("--directions", arguments->variant.directions,
                   "How many directions they are projected onto")
      ->check(CLI::Range(1, 64))
      ->capture_default_str()
      ->type_name("N");
  command->add_option("--turned", arguments->turn_degrees, "All directions turned by so much")
      ->type_name("DEGREES");
  command->callback([&action, arguments, minutes] {
    arguments->minutes_given = minutes->count() > 0;
    action = [arguments] { return run(*arguments); };
  });
}

}  // namespace posecoach
