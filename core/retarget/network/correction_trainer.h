// The training of the correction network: clips on made-up bodies, clean and as a webcam gives them; the
// truth is what geometry makes of the clean one.
#pragma once

#include "core/retarget/network/correction_network.h"
#include "core/retarget/network/training_loop.h"

namespace posecoach {

class CorrectionTrainee final : public Trainee {
 public:
  CorrectionTrainee(ClipSplit clips, const TrainingOptions& options);
  NamedValues step(double rate, std::mt19937_64& random) override;
  NamedValues validate() override;
  double geometry_error() override;
  WeightsFile weights() override;
  void save(torch::serialize::OutputArchive& archive) override;
  void load(torch::serialize::InputArchive& archive) override;

 private:
  // Windows of one skeleton family.
  struct Batch {
    torch::Tensor values;    // [batch, kCorrectionValues, time]
    torch::Tensor steadier;  // [batch, time, canonical joints, kSteadyTurns, 3]
    torch::Tensor turns;     // [batch, time, joints, 4], geometry's on the noisy motion, facing +Z
    torch::Tensor truth;     // the same on the clean motion
    torch::Tensor offsets;   // [batch, joints, 3], T-pose bones in chain heights
    torch::Tensor drivers;   // [joints], canonical joint of each
    torch::Tensor parents;   // [joints]
    torch::Tensor chains;    // [joints, joints]
  };
  Batch make_batch(std::span<const TurnClip> clips, int count, bool webcam_body,
                   std::mt19937_64& random) const;
  // Joints relative to the root.
  static torch::Tensor positions(const Batch& batch, const torch::Tensor& turns);
  torch::Tensor corrected(const Batch& batch);
  // What is trained and validated: the mean squared error of positions, and the mean length of their third
  // differences (what jitter is made of; also of what the truth has of it). Chain heights.
  struct Errors {
    torch::Tensor position, jitter;
    torch::Tensor both() const;
  };
  static Errors errors_of(const Batch& batch, const torch::Tensor& turns);

  ClipSplit clips_;
  TrainingOptions options_;
  CorrectionNetwork network_;
  std::unique_ptr<torch::optim::Adam> optimizer_;
  std::unique_ptr<AveragedParameters> averaged_;
  std::vector<Batch> held_out_;
};

}  // namespace posecoach
