// The loop around every training: time, learning rate, log, checkpoints, and the best weights so far.
#pragma once

#include <string>
#include <vector>

#include "core/transfer/evaluation.h"
#include "core/transfer/network/torch.h"
#include "core/transfer/training.h"

namespace posecoach {

// What is trained.
class TransferTrainee {
 public:
  virtual ~TransferTrainee() = default;
  virtual std::vector<std::string> loss_names() const = 0;
  // One update. `random` belongs to this iteration alone, so that a resumed training goes the same way;
  // `rate` in (0, 1] scales the learning rate. The losses in the order of their names.
  virtual std::vector<double> step(long iteration, double rate, std::mt19937_64& random) = 0;
  // The averaged network, as it would be shipped.
  virtual std::unique_ptr<Transferer> averaged() = 0;
  virtual std::string weights() = 0;
  // Everything that training needs to go on.
  virtual void save(torch::serialize::OutputArchive& archive) = 0;
  virtual void load(torch::serialize::InputArchive& archive) = 0;
};

// `held_out`: motions that the trainee never sees; their people are as fresh as those of the training.
Result<TransferTrainingSummary> run_transfer_training(TransferTrainee& trainee, const PoseClipPool& held_out,
                                                      const TransferTrainingOptions& options);

// Held-out and training part of the clips. Errors: Incomplete when there are too few.
Result<std::pair<PoseClipPool, PoseClipPool>> held_out_and_training(std::vector<PoseClip> clips);

}  // namespace posecoach
