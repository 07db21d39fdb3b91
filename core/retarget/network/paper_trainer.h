// The training of the paper's network (section 3.3): reconstruction and cycle paths between structures drawn
// anew in every step, unpaired.
#pragma once

#include "core/retarget/network/paper_losses.h"
#include "core/retarget/network/training_loop.h"

namespace posecoach {

PaperNetworkOptions network_options_of(PaperVariant variant);
PaperLossOptions loss_options_of(PaperVariant variant);

inline constexpr char kPaperWeightsKind[] = "posecoach.retarget.paper/2";

class PaperTrainee final : public Trainee {
 public:
  PaperTrainee(ClipSplit clips, const TrainingOptions& options);
  NamedValues step(double rate, std::mt19937_64& random) override;
  NamedValues validate() override;
  double geometry_error() override;
  WeightsFile weights() override;
  void save(torch::serialize::OutputArchive& archive) override;
  void load(torch::serialize::InputArchive& archive) override;

 private:
  BodyBatch draw(BodyLayoutKind kind, int count, std::mt19937_64& random) const;
  void measure();

  ClipSplit clips_;
  TrainingOptions options_;
  PaperLossOptions losses_;
  PaperNetwork network_{nullptr};
  std::array<MotionDiscriminator, kBodyLayoutKinds.size()> judges_{nullptr, nullptr, nullptr};
  std::unique_ptr<torch::optim::Adam> generator_optimizer_, judge_optimizer_;
  std::unique_ptr<AveragedParameters> averaged_;
  // Held-out windows, each with two bodies.
  std::vector<TurnClip> held_out_;
  std::vector<RoleBody> held_out_sources_, held_out_targets_;
};

// A body of the canonical joints, and a clip on it as positions.
Skeleton role_skeleton(const RoleBody& body);
Motion posed_motion(const RoleBody& body, const TurnClip& clip);

}  // namespace posecoach
