#include "core/retarget/network/paper_trainer.h"

#include <glm/geometric.hpp>

#include "core/base/assert.h"
#include "core/retarget/carry.h"

namespace posecoach {
namespace {

constexpr int kWindowFrames = 64;
constexpr int kHeldOutWindows = 32;
constexpr double kLearningRate = 1e-3;
constexpr double kAverageKeep = 0.999;

using enum BodyLayoutKind;

// How often a step carries motion from one structure to another. Mixamo rigs are what most motions come on.
struct StructurePair {
  BodyLayoutKind from, to;
  double share;
};
constexpr std::array kPairs = {
    StructurePair{Split28, Split28, 0.36},  StructurePair{Split28, OldRig23, 0.10},
    StructurePair{OldRig23, Split28, 0.22}, StructurePair{OldRig23, OldRig23, 0.06},
    StructurePair{Split28, Webcam38, 0.10}, StructurePair{Webcam38, Split28, 0.10},
    StructurePair{Webcam38, Webcam38, 0.06}};

void forget_gradients(torch::optim::Optimizer& optimizer) {
  for (auto& group : optimizer.param_groups())
    for (torch::Tensor& parameter : group.params()) parameter.mutable_grad().reset();
}

void set_rate(torch::optim::Adam& optimizer, double rate) {
  for (auto& group : optimizer.param_groups())
    static_cast<torch::optim::AdamOptions&>(group.options()).lr(rate);
}

}  // namespace

PaperNetworkOptions network_options_of(PaperVariant variant) {
  PaperNetworkOptions options;
  if (variant == PaperVariant::RootBased) options.input = PaperInput::RootBased;
  if (variant == PaperVariant::RotationInput) options.input = PaperInput::Rotations;
  return options;
}

PaperLossOptions loss_options_of(PaperVariant variant) {
  PaperLossOptions options;
  options.reconstruct_rows = variant != PaperVariant::NoRowLoss;
  options.cycle_root = variant == PaperVariant::RootCycle;
  options.discriminator = variant != PaperVariant::NoDiscriminator;
  return options;
}

PaperTrainee::PaperTrainee(ClipSplit clips, const TrainingOptions& options)
    : clips_(std::move(clips)), options_(options), losses_(loss_options_of(options.variant)) {
  torch::manual_seed(options.seed);
  network_ = PaperNetwork(network_options_of(options.variant));
  std::vector<torch::Tensor> judge_parameters;
  for (std::size_t i = 0; i < judges_.size(); ++i) {
    judges_[i] = MotionDiscriminator(BodyLayout::of(kBodyLayoutKinds[i]));
    for (const torch::Tensor& parameter : judges_[i]->parameters()) judge_parameters.push_back(parameter);
  }
  generator_optimizer_ = std::make_unique<torch::optim::Adam>(network_->parameters(), kLearningRate);
  judge_optimizer_ = std::make_unique<torch::optim::Adam>(judge_parameters, kLearningRate * 0.2);
  averaged_ = std::make_unique<AveragedParameters>(*network_, kAverageKeep);
  measure();
  std::mt19937_64 random(options.seed + 977);
  for (const MotionWindow& window : random_windows(clips_.held_out, kHeldOutWindows, kWindowFrames, random)) {
    held_out_.push_back(cut(window, kWindowFrames));
    held_out_sources_.push_back(random_role_body(random));
    held_out_targets_.push_back(random_role_body(random));
  }
}

BodyBatch PaperTrainee::draw(BodyLayoutKind kind, int count, std::mt19937_64& random) const {
  std::vector<TurnClip> clips;
  std::vector<RoleBody> bodies;
  for (const MotionWindow& window : random_windows(clips_.train, count, kWindowFrames, random)) {
    clips.push_back(cut(window, kWindowFrames));
    bodies.push_back(random_role_body(random));
  }
  return make_body_batch(kind, clips, bodies);
}

void PaperTrainee::measure() {
  std::mt19937_64 random(options_.seed + 31);
  for (const BodyLayoutKind kind : kBodyLayoutKinds)
    measure_rows(*network_->of(kind), network_->options().input, draw(kind, 128, random));
}

NamedValues PaperTrainee::step(double rate, std::mt19937_64& random) {
  std::vector<double> shares;
  for (const StructurePair& pair : kPairs) shares.push_back(pair.share);
  const StructurePair pair =
      kPairs[std::discrete_distribution<std::size_t>(shares.begin(), shares.end())(random)];
  const BodyBatch source = draw(pair.from, options_.batch, random);
  // Bodies to carry to, with other motions of their own: what the discriminator takes for real.
  const BodyBatch target = draw(pair.to, options_.batch, random);
  const MotionDiscriminator& judge = judges_[static_cast<std::size_t>(pair.to)];
  set_rate(*generator_optimizer_, kLearningRate * rate);
  set_rate(*judge_optimizer_, kLearningRate * 0.2 * rate);

  forget_gradients(*generator_optimizer_);
  const PaperLosses losses = paper_losses(*network_, judge, source, target, losses_);
  losses.total(losses_).backward();
  torch::nn::utils::clip_grad_norm_(network_->parameters(), 1.0);
  generator_optimizer_->step();
  averaged_->follow();
  NamedValues values = {{"reconstruction", losses.reconstruction.item<double>()},
                        {"cycle", losses.cycle.item<double>()},
                        {"end_effectors", losses.end_effectors.item<double>()},
                        {"adversarial", losses.adversarial.item<double>()}};
  if (losses_.discriminator) {
    forget_gradients(*judge_optimizer_);
    const torch::Tensor loss = discriminator_loss(judge, standard_rows(*network_->of(pair.to), target.motion),
                                                  losses.retargeted_rows);
    loss.backward();
    judge_optimizer_->step();
    values.emplace_back("discriminator", loss.item<double>());
  }
  return values;
}

NamedValues PaperTrainee::validate() {
  torch::NoGradGuard no_gradient;
  averaged_->swap();
  NamedValues errors;
  for (const auto& [name, from, to] :
       {std::tuple{"held_out_intra", Split28, Split28}, std::tuple{"held_out_cross", OldRig23, Split28},
        std::tuple{"held_out_webcam", Webcam38, Split28}}) {
    const BodyBatch source = make_body_batch(from, held_out_, held_out_sources_);
    const BodyBatch target = make_body_batch(to, held_out_, held_out_targets_);
    StructureNetworkImpl& in = *network_->of(from);
    StructureNetworkImpl& out = *network_->of(to);
    const torch::Tensor features = in.motion(input_rows(in, network_->options().input, source.motion));
    const MotionTensors carried =
        decode(out, features + skeleton_features(out, target.rest_bones), target.rest_bones);
    errors.emplace_back(name, local_error(out, carried, target.motion));
    if (from == to) {
      const MotionTensors again =
          decode(in, features + skeleton_features(in, source.rest_bones), source.rest_bones);
      errors.emplace_back("held_out_self", local_error(in, again, source.motion));
    }
  }
  averaged_->swap();
  return errors;
}

double PaperTrainee::geometry_error() {
  double sum = 0;
  for (std::size_t i = 0; i < held_out_.size(); ++i) {
    const Motion truth = posed_motion(held_out_targets_[i], held_out_[i]);
    const auto carried = carried_by_turns(posed_motion(held_out_sources_[i], held_out_[i]), truth.skeleton(),
                                          RetargetMethod::Rotation, RotationSource::Positions);
    POSECOACH_ASSERT(carried.has_value());
    double of_window = 0;
    for (int frame = 0; frame < truth.frame_count(); ++frame)
      for (int j = 0; j < truth.joint_count(); ++j) {
        const Vec3 off = (carried->position(frame, j) - carried->position(frame, 0)) -
                         (truth.position(frame, j) - truth.position(frame, 0));
        of_window += glm::dot(off, off);
      }
    const double height = held_out_targets_[i].rest_height;
    sum += of_window / (3.0 * truth.frame_count() * truth.joint_count() * height * height);
  }
  return sum / static_cast<double>(held_out_.size());
}

WeightsFile PaperTrainee::weights() {
  averaged_->swap();
  WeightsFile file{kPaperWeightsKind, {{"variant", static_cast<int64_t>(options_.variant)}}, {}};
  for (const auto& [key, tensor] : tensors_of(*network_)) file.tensors[key] = tensor.clone();
  averaged_->swap();
  return file;
}

void PaperTrainee::save(torch::serialize::OutputArchive& archive) {
  const auto part = [&](const char* key, const auto& what) {
    torch::serialize::OutputArchive inner;
    what->save(inner);
    archive.write(key, inner);
  };
  archive.write("variant", torch::IValue(static_cast<int64_t>(options_.variant)));
  part("network", network_);
  for (std::size_t i = 0; i < judges_.size(); ++i) part(("judge" + std::to_string(i)).c_str(), judges_[i]);
  part("generator_optimizer", generator_optimizer_);
  part("judge_optimizer", judge_optimizer_);
  averaged_->save(archive, "averaged");
}

void PaperTrainee::load(torch::serialize::InputArchive& archive) {
  torch::IValue variant;
  archive.read("variant", variant);
  if (variant.toInt() != static_cast<int64_t>(options_.variant)) throw std::runtime_error("another variant");
  const auto part = [&](const char* key, auto& what) {
    torch::serialize::InputArchive inner;
    archive.read(key, inner);
    what->load(inner);
  };
  part("network", network_);
  for (std::size_t i = 0; i < judges_.size(); ++i) part(("judge" + std::to_string(i)).c_str(), judges_[i]);
  part("generator_optimizer", generator_optimizer_);
  part("judge_optimizer", judge_optimizer_);
  averaged_->load(archive, "averaged");
}

Skeleton role_skeleton(const RoleBody& body) {
  std::vector<Joint> joints;
  for (const HumanoidJoint role : kHumanoidJoints) {
    const auto parent = canonical_parent(role);
    joints.push_back({std::string(to_string(role)), parent ? static_cast<int>(*parent) : kNoJoint,
                      body.rest[role] - (parent ? body.rest[*parent] : Vec3(0)), role});
  }
  Result<Skeleton> made = Skeleton::make(std::move(joints));
  POSECOACH_ASSERT(made.has_value());
  return *std::move(made);
}

Motion posed_motion(const RoleBody& body, const TurnClip& clip) {
  std::vector<MediaTime> times;
  std::vector<Vec3> positions;
  for (const TurnFrame& frame : clip.frames) {
    times.push_back(media_time_from_seconds(static_cast<double>(times.size()) / kNetworkFramesPerSecond));
    const RoleArray<Vec3> at = posed(body, frame);
    positions.insert(positions.end(), at.begin(), at.end());
  }
  Result<Motion> made = Motion::from_positions(role_skeleton(body), std::move(times), std::move(positions));
  POSECOACH_ASSERT(made.has_value());
  return *std::move(made);
}

}  // namespace posecoach
