#include "core/transfer/network/trained_transferers.h"
#include "core/transfer/network/transfer_network.h"
#include "core/transfer/network/transfer_training_loop.h"

namespace posecoach {
namespace {

constexpr std::size_t kBatch = 128;
constexpr double kLearningRate = 1e-3;
constexpr double kLargestGradient = 1.0;
constexpr double kLengthWeight = 0.15, kBoneWeight = 0.5, kErrorWeight = 0.1, kTouchWeight = 0.02;

// What detectors do to real pictures, in fractions of stature.
void spoil(std::vector<Pose2d>& pictures, double noise, double missing, std::mt19937_64& random) {
  std::normal_distribution<double> error(0, noise);
  std::uniform_real_distribution<double> chance(0, 1);
  for (Pose2d& picture : pictures) {
    for (std::size_t i = 0; i < kJoint2dCount; ++i) {
      if (noise > 0) picture.positions[i] += Vec2{error(random), error(random)};
      if (missing > 0 && chance(random) < missing) picture.seen[i] = false;
    }
    picture = with_midpoints(picture);
  }
}

class NetworkTrainee : public TransferTrainee {
 public:
  NetworkTrainee(const PoseClipPool& pool, std::uint64_t seed) : pool_(pool) {
    torch::manual_seed(seed);
    network_ = std::make_shared<TransferNetwork>();
    average_ = std::make_shared<TransferNetwork>();
    move_transfer_average(*average_, *network_, 0);
    rule_ = std::make_unique<torch::optim::Adam>(network_->parameters(),
                                                 torch::optim::AdamOptions(kLearningRate));
  }

  std::vector<std::string> loss_names() const override { return {"joints", "bones", "lengths", "touch"}; }

  std::vector<double> step(long iteration, double rate, std::mt19937_64& random) override {
    const Batch batch = sample(random);
    const TransferNetwork::Person source = network_->encode(batch.source, batch.source_person);
    const TransferNetwork::Person identity = network_->encode(batch.identity, batch.identity_person);
    const TransferNetwork::Result result = network_->forward(batch.pose, source, identity);
    // In true statures, so that every person counts the same.
    const torch::Tensor bones = result.bones * batch.measured_per_true.view({-1, 1, 1});
    torch::Tensor joints = joints_from_bones(bones), truth = joints_from_bones(batch.truth);
    joints = joints - joints.mean(1, true);
    truth = truth - truth.mean(1, true);
    const torch::Tensor distance = ((joints - truth).square().sum(2) + 1e-8).sqrt();
    const torch::Tensor joint_loss = distance.mean();
    const torch::Tensor bone_loss = ((bones - batch.truth).square().sum(2) + 1e-8).sqrt().mean();
    const torch::Tensor length_loss = (source.log_lengths - batch.source_log_lengths).abs().mean() +
                                      (identity.log_lengths - batch.identity_log_lengths).abs().mean();
    const torch::Tensor error_loss =
        (result.expected_error * batch.measured_per_true.unsqueeze(1) - distance.detach()).abs().mean();
    const torch::Tensor touch_loss =
        torch::nn::functional::binary_cross_entropy_with_logits(result.touch, batch.touch);
    for (torch::optim::OptimizerParamGroup& group : rule_->param_groups())
      group.options().set_lr(kLearningRate * rate);
    rule_->zero_grad();
    (joint_loss + kBoneWeight * bone_loss + kLengthWeight * length_loss + kErrorWeight * error_loss +
     kTouchWeight * touch_loss)
        .backward();
    torch::nn::utils::clip_grad_norm_(network_->parameters(), kLargestGradient);
    rule_->step();
    move_transfer_average(*average_, *network_, transfer_average_keeps(iteration));
    return {joint_loss.item<double>(), bone_loss.item<double>(), length_loss.item<double>(),
            touch_loss.item<double>()};
  }

  std::unique_ptr<Transferer> averaged() override { return make_network_transferer(average_); }
  std::string weights() override { return transfer_weights_of(*average_, kNetworkKind); }

  void save(torch::serialize::OutputArchive& archive) override {
    const auto nested = [&](const char* name, const auto& thing) {
      torch::serialize::OutputArchive inner(archive.compilation_unit());
      thing.save(inner);
      archive.write(name, inner);
    };
    nested("network", *network_);
    nested("average", *average_);
    nested("rule", *rule_);
  }
  void load(torch::serialize::InputArchive& archive) override {
    const auto nested = [&](const char* name, auto& thing) {
      torch::serialize::InputArchive inner;
      archive.read(name, inner);
      thing.load(inner);
    };
    nested("network", *network_);
    nested("average", *average_);
    nested("rule", *rule_);
  }

 private:
  struct Batch {
    torch::Tensor pose;                                      // [N, picture]
    torch::Tensor source, identity;                          // [N, K, picture]
    torch::Tensor source_person, identity_person;            // [N, person]
    torch::Tensor truth;                                     // [N, 14, 2], in true statures
    torch::Tensor measured_per_true;                         // [N], of the second person's stature
    torch::Tensor source_log_lengths, identity_log_lengths;  // [N, 14], true, in measured statures
    torch::Tensor touch;                                     // [N]
  };

  static SampleOptions random_options(std::mt19937_64& random) {
    constexpr std::array<std::size_t, 6> kIdentityPictures = {1, 1, 2, 4, 8, 8};
    constexpr std::array<std::size_t, 6> kSourcePictures = {1, 3, 8, 16, 32, 32};
    SampleOptions options;
    options.identity_pictures = kIdentityPictures[random() % kIdentityPictures.size()];
    options.source_pictures = kSourcePictures[random() % kSourcePictures.size()];
    options.one_source_view = random() % 4 != 0;
    return options;
  }

  Batch sample(std::mt19937_64& random) const {
    const SampleOptions options = random_options(random);
    const int64_t n = static_cast<int64_t>(kBatch), bones = static_cast<int64_t>(kBone2dCount);
    Batch batch;
    batch.pose = torch::empty({n, kPictureNumbers});
    batch.source = torch::empty({n, static_cast<int64_t>(options.source_pictures), kPictureNumbers});
    batch.identity = torch::empty({n, static_cast<int64_t>(options.identity_pictures), kPictureNumbers});
    batch.source_person = torch::empty({n, kPersonNumbers});
    batch.identity_person = torch::empty({n, kPersonNumbers});
    batch.truth = torch::empty({n, bones, 2});
    batch.measured_per_true = torch::empty({n});
    batch.source_log_lengths = torch::empty({n, bones});
    batch.identity_log_lengths = torch::empty({n, bones});
    batch.touch = torch::empty({n});
    for (std::size_t i = 0; i < kBatch; ++i) fill(batch, i, options, random);
    return batch;
  }

  void fill(Batch& batch, std::size_t i, const SampleOptions& options, std::mt19937_64& random) const {
    const auto row = [i](torch::Tensor& tensor) {
      return tensor.data_ptr<float>() + i * static_cast<std::size_t>(tensor.stride(0));
    };
    while (true) {
      TransferSample sample = random_sample(pool_, random, options);
      const int kind = static_cast<int>(random() % 8);
      const double noise = kind < 3 ? 0.006 * sample.stature_m : 0,
                   missing = kind == 0 || kind == 7 ? 0.06 : 0;
      spoil(sample.source, noise, missing, random);
      spoil(sample.identity, noise, missing, random);
      const Result<BoneLengths2d> from = measure_bone_lengths(sample.source),
                                  to = measure_bone_lengths(sample.identity);
      if (!from || !to) continue;
      write_picture(sample.source.front(), from->stature, row(batch.pose));
      for (std::size_t k = 0; k < sample.source.size(); ++k)
        write_picture(sample.source[k], from->stature, row(batch.source) + k * std::size_t{kPictureNumbers});
      for (std::size_t k = 0; k < sample.identity.size(); ++k)
        write_picture(sample.identity[k], to->stature,
                      row(batch.identity) + k * std::size_t{kPictureNumbers});
      write_person(*from, row(batch.source_person));
      write_person(*to, row(batch.identity_person));
      for (std::size_t b = 0; b < kBone2dCount; ++b) {
        const Vec2 bone = *bone_vector(sample.truth, b) / sample.stature_m;
        row(batch.truth)[2 * b] = static_cast<float>(bone.x);
        row(batch.truth)[2 * b + 1] = static_cast<float>(bone.y);
        row(batch.source_log_lengths)[b] =
            static_cast<float>(std::log(sample.source_lengths[b] / from->stature));
        row(batch.identity_log_lengths)[b] =
            static_cast<float>(std::log(sample.identity_lengths[b] / to->stature));
      }
      row(batch.measured_per_true)[0] = static_cast<float>(to->stature / sample.stature_m);
      row(batch.touch)[0] = sample.hands_touch ? 1.0F : 0.0F;
      return;
    }
  }

  const PoseClipPool& pool_;
  std::shared_ptr<TransferNetwork> network_, average_;
  std::unique_ptr<torch::optim::Adam> rule_;
};

}  // namespace

Result<TransferTrainingSummary> train_network_transfer(std::vector<PoseClip> clips,
                                                       const TransferTrainingOptions& options) {
  use_one_core_for_transfer();
  Result<std::pair<PoseClipPool, PoseClipPool>> pools = held_out_and_training(std::move(clips));
  if (!pools) return tl::unexpected(pools.error());
  NetworkTrainee trainee(pools->second, options.seed);
  return run_transfer_training(trainee, pools->first, options);
}

}  // namespace posecoach
