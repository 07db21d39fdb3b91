#include "core/transfer/network/losses.h"
#include "core/transfer/network/paper_network.h"
#include "core/transfer/network/trained_transferers.h"
#include "core/transfer/network/transfer_training_loop.h"

namespace posecoach {
namespace {

// The paper's settings.
constexpr int64_t kPaperBatch = 64;
constexpr double kFeatureWeight = 1, kSameWeight = 0.5, kLinkWeight = 300, kAngleWeight = 2;
constexpr double kSigma = 0.05;
constexpr double kPaperLearningRate = 1e-4;
// FUNIT's 10 is for pictures of thousands of numbers; on 30 it leaves the discriminator no slope to tell bone
// lengths by.
constexpr double kGradientPenalty = 0.01;
// The ranking loss is about log 2 where the virtual link loss is zero; at the same weight it would drown the
// rest.
constexpr double kRankingWeight = 2;
// More people than the paper's 12 to 15: ours are free.
constexpr std::size_t kIdentities = 240;

// Statures are measured from foreshortened pictures, so they still differ a little from kPaperStature_m.
SyntheticBody of_likely_stature(SyntheticBody body, std::mt19937_64& random) {
  const double wanted = kPaperStature_m * std::uniform_real_distribution<double>(0.87, 1.16)(random);
  const double factor = wanted / stature_from_lengths(body.length_m);
  for (double& length : body.length_m) length *= factor;
  body.nose_forward_up_m *= factor;
  return body;
}

class PaperTrainee : public TransferTrainee {
 public:
  PaperTrainee(const PoseClipPool& pool, std::uint64_t seed, const PaperTransferVariant& variant)
      : pool_(pool),
        variant_(variant),
        links_(links(variant.links), projection_directions(variant.directions, variant.directions_turned)) {
    torch::manual_seed(seed);
    std::mt19937_64 random(seed);
    for (std::size_t i = 0; i < kIdentities; ++i)
      identities_.push_back(of_likely_stature(random_body(random, SyntheticVariety::Mixed), random));
    generator_ = std::make_shared<PaperTransferGenerator>();
    average_ = std::make_shared<PaperTransferGenerator>();
    move_transfer_average(*average_, *generator_, 0);
    discriminator_ = std::make_shared<PaperTransferDiscriminator>(static_cast<int64_t>(kIdentities));
    const auto options = torch::optim::RMSpropOptions(kPaperLearningRate).weight_decay(1e-4);
    generator_rule_ = std::make_unique<torch::optim::RMSprop>(generator_->parameters(), options);
    discriminator_rule_ = std::make_unique<torch::optim::RMSprop>(discriminator_->parameters(), options);
  }

  std::vector<std::string> loss_names() const override {
    return {"discriminator", "generator", "features", "same", "pose"};
  }

  std::vector<double> step(long iteration, double, std::mt19937_64& random) override {
    const Batch batch = sample(random);
    // The discriminator learns from the identity's real pictures and from what the generator makes.
    torch::Tensor made;
    {
      const torch::NoGradGuard no_grad;
      made = generator_->forward(batch.poses, batch.pictures.unsqueeze(1));
    }
    const torch::Tensor real = batch.pictures.clone().set_requires_grad(true);
    const torch::Tensor real_score = discriminator_->forward(real, batch.identities).score;
    const torch::Tensor made_score = discriminator_->forward(made, batch.identities).score;
    const torch::Tensor slope = torch::autograd::grad({real_score.sum()}, {real}, {}, true, true)[0]
                                    .flatten(1)
                                    .square()
                                    .sum(1)
                                    .mean();
    const torch::Tensor discriminator_loss =
        torch::relu(1 - real_score).mean() + torch::relu(1 + made_score).mean();
    discriminator_rule_->zero_grad();
    (discriminator_loss + kGradientPenalty * slope).backward();
    discriminator_rule_->step();

    const torch::Tensor result = generator_->forward(batch.poses, batch.pictures.unsqueeze(1));
    const PaperTransferDiscriminator::Answer answer = discriminator_->forward(result, batch.identities);
    torch::Tensor wanted;
    {
      const torch::NoGradGuard no_grad;
      wanted = discriminator_->forward(batch.pictures, batch.identities).features;
    }
    const torch::Tensor adversarial = -answer.score.mean();
    const torch::Tensor features = (answer.features - wanted).abs().mean();
    // Equation 3: the first half of the batch is of one person, the second of two.
    const int64_t half = kPaperBatch / 2;
    const torch::Tensor same =
        (result.slice(0, 0, half) - batch.poses.slice(0, 0, half)).abs().flatten(1).sum(1).mean();
    const torch::Tensor pose = pose_loss(batch.poses.slice(0, half), result.slice(0, half));
    generator_rule_->zero_grad();
    (adversarial + kFeatureWeight * features + 0.5 * kSameWeight * same + 0.5 * pose).backward();
    generator_rule_->step();
    move_transfer_average(*average_, *generator_, transfer_average_keeps(iteration));
    return {discriminator_loss.item<double>(), adversarial.item<double>(), features.item<double>(),
            same.item<double>(), pose.item<double>()};
  }

  std::unique_ptr<Transferer> averaged() override { return make_paper_transferer(average_); }
  std::string weights() override { return transfer_weights_of(*average_, kPaperKind); }

  void save(torch::serialize::OutputArchive& archive) override {
    const auto nested = [&](const char* name, const auto& thing) {
      torch::serialize::OutputArchive inner(archive.compilation_unit());
      thing.save(inner);
      archive.write(name, inner);
    };
    nested("generator", *generator_);
    nested("average", *average_);
    nested("discriminator", *discriminator_);
    nested("generator_rule", *generator_rule_);
    nested("discriminator_rule", *discriminator_rule_);
  }
  void load(torch::serialize::InputArchive& archive) override {
    const auto nested = [&](const char* name, auto& thing) {
      torch::serialize::InputArchive inner;
      archive.read(name, inner);
      thing.load(inner);
    };
    nested("generator", *generator_);
    nested("average", *average_);
    nested("discriminator", *discriminator_);
    nested("generator_rule", *generator_rule_);
    nested("discriminator_rule", *discriminator_rule_);
  }

 private:
  struct Batch {
    torch::Tensor poses;       // x_A
    torch::Tensor pictures;    // y_B
    torch::Tensor identities;  // B
  };

  // A picture of one of the known people doing anything; no pose is ever seen on two people at once.
  torch::Tensor picture(std::size_t identity, std::mt19937_64& random) const {
    const PoseClip& clip = pool_.random_clip(random);
    const Pose3d& pose =
        clip.poses[std::uniform_int_distribution<std::size_t>(0, clip.poses.size() - 1)(random)];
    const CameraTurn view{std::uniform_real_distribution<double>(-kPi, kPi)(random), 0};
    const Pose2d seen = project(on_body(pose, clip.lengths, identities_[identity]), view);
    return paper_tensor(random() % 2 == 0 ? seen : mirrored(seen), kPaperUnitsPerMetre);
  }

  Batch sample(std::mt19937_64& random) const {
    std::uniform_int_distribution<std::size_t> any(0, kIdentities - 1);
    std::vector<torch::Tensor> poses, pictures;
    std::vector<int64_t> identities;
    for (int64_t i = 0; i < kPaperBatch; ++i) {
      const std::size_t to = any(random), from = i < kPaperBatch / 2 ? to : any(random);
      poses.push_back(picture(from, random));
      pictures.push_back(picture(to, random));
      identities.push_back(static_cast<int64_t>(to));
    }
    return {torch::stack(poses), torch::stack(pictures), torch::tensor(identities)};
  }

  torch::Tensor pose_loss(const torch::Tensor& source, const torch::Tensor& result) const {
    switch (variant_.loss) {
      case TransferPoseLoss::None:
        return torch::zeros({});
      case TransferPoseLoss::Ranking:
        return kRankingWeight * ranking_loss(source, result, links_, kSigma);
      case TransferPoseLoss::VirtualLinks:
        return kLinkWeight * virtual_link_loss(source, result, links_, kSigma);
      case TransferPoseLoss::Angles:
        return kAngleWeight * angle_loss(source, result);
      case TransferPoseLoss::VirtualLinksAndAngles:
        return kLinkWeight * virtual_link_loss(source, result, links_, kSigma) +
               kAngleWeight * angle_loss(source, result);
    }
    return torch::zeros({});
  }

  const PoseClipPool& pool_;
  PaperTransferVariant variant_;
  LinkProjection links_;
  std::vector<SyntheticBody> identities_;
  std::shared_ptr<PaperTransferGenerator> generator_, average_;
  std::shared_ptr<PaperTransferDiscriminator> discriminator_;
  std::unique_ptr<torch::optim::RMSprop> generator_rule_, discriminator_rule_;
};

}  // namespace

Result<TransferTrainingSummary> train_paper_transfer(std::vector<PoseClip> clips,
                                                     const TransferTrainingOptions& options,
                                                     const PaperTransferVariant& variant) {
  use_one_core_for_transfer();
  Result<std::pair<PoseClipPool, PoseClipPool>> pools = held_out_and_training(std::move(clips));
  if (!pools) return tl::unexpected(pools.error());
  PaperTrainee trainee(pools->second, options.seed, variant);
  return run_transfer_training(trainee, pools->first, options);
}

}  // namespace posecoach
