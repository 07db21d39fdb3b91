// Training of the transfer networks on synthetic people performing recorded motions.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/transfer/clip_pool.h"
#include "core/transfer/pose_similarity.h"

namespace posecoach {

// What makes the pose loss of the paper's network: the rows of its Table 2.
enum class TransferPoseLoss { None, Ranking, VirtualLinks, Angles, VirtualLinksAndAngles };
struct PaperTransferVariant {
  TransferPoseLoss loss = TransferPoseLoss::VirtualLinksAndAngles;
  Links links = Links::All;      // Table 3
  int directions = 4;            // Table 3
  double directions_turned = 0;  // Table 4, radians
};

struct TransferTrainingOptions {
  // Beside the weights: `.checkpoint` (to resume), `.csv` (the log) and `.png` (its curves).
  std::filesystem::path weights;
  double minutes = 30;
  long iterations = 0;  // 0: until the minutes are over
  bool resume = false;
  std::uint64_t seed = 1;
  Progress progress;  // says no: the training stops cleanly, to be resumed
};

struct TransferTrainingSummary {
  long iterations = 0;
  double minutes = 0;       // of this run and those that it resumed
  double best_score = 0;    // mean OKS on held-out people and motions, percent, at its best
  long best_iteration = 0;  // whose weights were kept
  bool stopped = false;     // before its time, by the user
};

// Errors: Incomplete (too few clips), Unreadable (weights cannot be written), Malformed (a checkpoint of
// something else).
Result<TransferTrainingSummary> train_paper_transfer(std::vector<PoseClip> clips,
                                                     const TransferTrainingOptions& options,
                                                     const PaperTransferVariant& variant);
Result<TransferTrainingSummary> train_network_transfer(std::vector<PoseClip> clips,
                                                       const TransferTrainingOptions& options);

}  // namespace posecoach
