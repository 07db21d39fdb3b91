// Training of the retargeting networks: from recorded motions and bodies made up on the way to a file of
// weights. Resumable, seeded, and stopped cleanly when asked.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/retarget/network/turn_clip.h"

namespace posecoach {

enum class TrainedMethod { Paper, Network };
enum class PaperVariant : unsigned char {
  Paper,            // as printed
  RootBased,        // joints relative to the root
  NoRowLoss,        // L'_rec
  RootCycle,        // L'_cyc
  NoDiscriminator,  // L_adv off
  RotationInput     // PAN: rotations instead of positions
};
std::string_view to_string(PaperVariant variant);
Result<PaperVariant> paper_variant_from_string(std::string_view name);

// What a line of the log tells; the columns of the CSV beside the weights.
struct TrainingReport {
  long iteration = 0;
  double minutes = 0, of_minutes = 0;
  std::vector<std::pair<std::string, double>> values;  // losses since the last report, held-out errors
};

struct TrainingOptions {
  TrainedMethod method = TrainedMethod::Paper;
  PaperVariant variant = PaperVariant::Paper;
  std::filesystem::path data, weights;
  double minutes = 60;  // of one core
  bool resume = false;
  std::uint64_t seed = 1;
  int batch = 16;
  double report_every_s = 20;
  double validate_every_s = 120;
  // Called with every report; false stops the training after it saved its state.
  std::function<bool(const TrainingReport&)> watch;
  // Asked after every step.
  std::function<bool()> stop;
};

struct TrainingSummary {
  long iterations = 0;
  double best_error = 0;      // held-out, what was optimised for
  double geometry_error = 0;  // the method `rotation` on the same
  bool finished = false;      // false: stopped early, can be resumed
};

// Writes `weights`, `weights`.csv with its curves in `weights`.png and, to be resumed, `weights`.checkpoint.
// Errors: NotFound, Incomplete (no motions), Malformed (a checkpoint of something else).
Result<TrainingSummary> train_retargeting(const TrainingOptions& options);

// All motions (.bvh, .amc) below a folder, except those in folders named "paired", which are for measuring,
// and the bundled ones. A file that cannot be used is told to the log. In the order of their paths.
Result<std::vector<TurnClip>> load_training_clips(const std::filesystem::path& folder);

// Every eighth clip is kept for validation.
struct ClipSplit {
  std::vector<TurnClip> train, held_out;
};
ClipSplit split_clips(std::vector<TurnClip> clips);

// Golf is what the program is for and the least of what there is: its clips (in a folder or file named after
// it, and the bundled ones) are repeated until they make this share of all frames.
void repeat_golf(std::vector<TurnClip>& clips, double share);

}  // namespace posecoach
