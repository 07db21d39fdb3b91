#include "core/retarget/network/correction_trainer.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/base/assert.h"
#include "core/base/index.h"
#include "core/body/landmark_body.h"
#include "core/retarget/doubt.h"
#include "core/retarget/network/paper_trainer.h"
#include "core/retarget/t_pose.h"
#include "core/retarget/webcam_noise.h"

namespace posecoach {
namespace {

constexpr int kWindowFrames = 64;
constexpr int kHeldOutWindows = 32;
constexpr double kLearningRate = 1.5e-3;
constexpr double kAverageKeep = 0.995;
// Of jitter against squared error; about as much as makes both fall alike.
constexpr double kJitterWeight = 0.12;
// A student's bones are measured, not known.
constexpr double kMeasuringError = 0.03;

// The clip on a body as the pose stage's landmarks would be, if they were exact.
Motion landmark_motion(const RoleBody& body, const TurnClip& clip, std::mt19937_64& random) {
  const BodyLayout& layout = BodyLayout::of(BodyLayoutKind::Webcam38);
  const auto names = landmark_body_joints();
  std::vector<Vec3> at(kLandmarkBodyJointCount);
  layout.place(body.rest, RoleArray<Quat>{}, body.rest_height, at);
  std::vector<Joint> joints;
  for (std::size_t j = 0; j < names.size(); ++j) {
    const int parent = names[j].parent;
    const Vec3 offset = at[j] - (parent == kNoJoint ? Vec3(0) : at[index(parent)]);
    const double measured =
        1 + std::uniform_real_distribution<double>(-kMeasuringError, kMeasuringError)(random);
    joints.push_back({names[j].name, parent, parent == kNoJoint ? offset : measured * offset, names[j].role});
  }
  std::vector<MediaTime> times;
  std::vector<Vec3> positions;
  for (const TurnFrame& frame : clip.frames) {
    times.push_back(media_time_from_seconds(static_cast<double>(times.size()) / kNetworkFramesPerSecond));
    layout.place(posed(body, frame), frame.turns, body.rest_height, at);
    positions.insert(positions.end(), at.begin(), at.end());
  }
  Result<Skeleton> skeleton = Skeleton::make(std::move(joints));
  POSECOACH_ASSERT(skeleton.has_value());
  Result<Motion> made = Motion::from_positions(*std::move(skeleton), std::move(times), std::move(positions));
  POSECOACH_ASSERT(made.has_value());
  return *std::move(made);
}

// The whole scene turned about the vertical: the camera stands anywhere.
TurnClip turned(TurnClip clip, double angle) {
  const Quat turn = glm::angleAxis(angle, Vec3(0, 1, 0));
  for (TurnFrame& frame : clip.frames) {
    for (Quat& q : frame.turns) q = turn * q;
    frame.hips = turn * frame.hips;
  }
  return clip;
}

void copy(const std::vector<Quat>& turns, const std::vector<double>& headings, std::size_t joints,
          float* to) {
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const Quat q = glm::angleAxis(-headings[i / joints], Vec3(0, 1, 0)) * turns[i];
    for (const double value : {q.w, q.x, q.y, q.z}) *to++ = static_cast<float>(value);
  }
}

}  // namespace

CorrectionTrainee::CorrectionTrainee(ClipSplit clips, const TrainingOptions& options)
    : clips_(std::move(clips)), options_(options) {
  torch::manual_seed(options.seed);
  network_ = CorrectionNetwork(CorrectionNetworkOptions());
  optimizer_ = std::make_unique<torch::optim::Adam>(network_->parameters(), kLearningRate);
  averaged_ = std::make_unique<AveragedParameters>(*network_, kAverageKeep);
  std::mt19937_64 random(options.seed + 31);
  torch::NoGradGuard no_gradient;
  const torch::Tensor values = torch::cat({make_batch(clips_.train, 24, false, random).values,
                                           make_batch(clips_.train, 24, true, random).values})
                                   .transpose(1, 2)
                                   .flatten(0, 1);
  network_->mean.copy_(values.mean(0).unsqueeze(1));
  network_->deviation.copy_((values.std(0, false) + 0.05).unsqueeze(1));
  std::mt19937_64 held_out_random(977);
  for (const bool webcam_body : {true, false})
    held_out_.push_back(make_batch(clips_.held_out, kHeldOutWindows, webcam_body, held_out_random));
}

CorrectionTrainee::Batch CorrectionTrainee::make_batch(std::span<const TurnClip> clips, int count,
                                                       bool webcam_body, std::mt19937_64& random) const {
  Batch batch;
  float *values = nullptr, *steadier = nullptr, *turns = nullptr, *truths = nullptr, *offsets = nullptr;
  for (const MotionWindow& window : random_windows(clips, count, kWindowFrames, random)) {
    const double yaw = std::uniform_real_distribution<double>(-kPi, kPi)(random);
    const TurnClip clip = turned(cut(window, kWindowFrames), yaw);
    const RoleBody body = random_role_body(random, {.cartoon_share = 0.1});
    const Motion clean = webcam_body ? landmark_motion(body, clip, random) : posed_motion(body, clip);
    const Motion raw = with_webcam_noise(clean, random);
    const CorrectionFrames frames = correction_frames(raw);
    const Skeleton& skeleton = clean.skeleton();
    const std::size_t joints = index(skeleton.size());
    if (!values) {
      const int64_t size = skeleton.size();
      batch.values = torch::empty({count, kWindowFrames, kCorrectionValues});
      batch.steadier =
          torch::empty({count, kWindowFrames, static_cast<int64_t>(kHumanoidJointCount), kSteadyTurns, 3});
      batch.turns = torch::empty({count, kWindowFrames, size, 4});
      batch.truth = torch::empty({count, kWindowFrames, size, 4});
      batch.offsets = torch::empty({count, size, 3});
      values = batch.values.data_ptr<float>();
      steadier = batch.steadier.data_ptr<float>();
      turns = batch.turns.data_ptr<float>();
      truths = batch.truth.data_ptr<float>();
      offsets = batch.offsets.data_ptr<float>();
      batch.drivers = torch::empty({size}, torch::kLong);
      batch.parents = torch::zeros({size}, torch::kLong);
      batch.chains = torch::zeros({size, size});
      for (int j = 0; j < skeleton.size(); ++j) {
        batch.drivers[j] = static_cast<int64_t>(frames.driver[index(j)]);
        batch.parents[j] = std::max(0, skeleton.joint(j).parent);
        for (int a = j; a != kNoJoint; a = skeleton.joint(a).parent)
          if (a != 0) batch.chains[j][a] = 1;
      }
    }
    values = std::copy(frames.values.begin(), frames.values.end(), values);
    steadier = std::copy(frames.steadier.begin(), frames.steadier.end(), steadier);
    copy(frames.turns, frames.headings, joints, turns);
    copy(recovered_turns(clean), frames.headings, joints, truths);
    turns += frames.turns.size() * 4;
    truths += frames.turns.size() * 4;
    const TPose t_pose = make_t_pose(skeleton);
    for (std::size_t j = 0; j < joints; ++j)
      for (int i = 0; i < 3; ++i)
        *offsets++ = static_cast<float>(t_pose.offsets[j][i] / skeleton.rest_height());
  }
  batch.values = batch.values.transpose(1, 2).contiguous();
  return batch;
}

torch::Tensor CorrectionTrainee::positions(const Batch& batch, const torch::Tensor& turns) {
  const torch::Tensor of_parent = turns.index_select(2, batch.parents);
  const torch::Tensor bones = batch.offsets.unsqueeze(1);
  const torch::Tensor w = of_parent.narrow(-1, 0, 1), v = of_parent.narrow(-1, 1, 3);
  const torch::Tensor across = 2 * torch::cross(v, bones.expand_as(v), -1);
  return torch::matmul(batch.chains, bones + w * across + torch::cross(v, across, -1));
}

torch::Tensor CorrectionTrainee::corrected(const Batch& batch) {
  const torch::Tensor vectors = network_(batch.values, batch.steadier).index_select(2, batch.drivers);
  return quaternion_product(quaternions_from_vectors(vectors), batch.turns);
}

torch::Tensor CorrectionTrainee::Errors::both() const {
  return position + kJitterWeight * jitter;
}

CorrectionTrainee::Errors CorrectionTrainee::errors_of(const Batch& batch, const torch::Tensor& turns) {
  const torch::Tensor said = positions(batch, turns);
  const torch::Tensor off = said - positions(batch, batch.truth);
  const torch::Tensor third = said.diff(3, 1);
  return {off.square().mean(), (third.square().sum(-1) + 1e-8).sqrt().mean()};
}

NamedValues CorrectionTrainee::step(double rate, std::mt19937_64& random) {
  const bool webcam_body = std::bernoulli_distribution(0.5)(random);
  const Batch batch = make_batch(clips_.train, options_.batch, webcam_body, random);
  for (auto& group : optimizer_->param_groups()) {
    static_cast<torch::optim::AdamOptions&>(group.options()).lr(kLearningRate * rate);
    for (torch::Tensor& parameter : group.params()) parameter.mutable_grad().reset();
  }
  const Errors errors = errors_of(batch, corrected(batch));
  (1000 * errors.both()).backward();
  torch::nn::utils::clip_grad_norm_(network_->parameters(), 1.0);
  optimizer_->step();
  averaged_->follow();
  return {{"position", errors.position.item<double>()}, {"jitter", errors.jitter.item<double>()}};
}

// Relative to geometry, so that neither body nor neither error counts for more.
NamedValues CorrectionTrainee::validate() {
  torch::NoGradGuard no_gradient;
  averaged_->swap();
  NamedValues values = {{"held_out", 0.0}};
  for (const Batch& batch : held_out_) {
    const std::string of = values.size() == 1 ? "_webcam_body" : "_rig";
    const Errors errors = errors_of(batch, corrected(batch)), geometry = errors_of(batch, batch.turns);
    const auto share = [](const torch::Tensor& a, const torch::Tensor& b) {
      return a.item<double>() / b.item<double>();
    };
    values.emplace_back("position" + of, share(errors.position, geometry.position));
    values.emplace_back("jitter" + of, share(errors.jitter, geometry.jitter));
    for (std::size_t i = values.size() - 2; i < values.size(); ++i)
      values[0].second += 0.5 * values[i].second / static_cast<double>(held_out_.size());
  }
  averaged_->swap();
  return values;
}

double CorrectionTrainee::geometry_error() {
  return 1;  // what held-out errors are measured in
}

WeightsFile CorrectionTrainee::weights() {
  averaged_->swap();
  WeightsFile file{kCorrectionWeightsKind, {}, {}};
  for (const auto& [key, tensor] : tensors_of(*network_)) file.tensors[key] = tensor.clone();
  averaged_->swap();
  return file;
}

void CorrectionTrainee::save(torch::serialize::OutputArchive& archive) {
  torch::serialize::OutputArchive network, optimizer;
  network_->save(network);
  optimizer_->save(optimizer);
  archive.write("network", network);
  archive.write("optimizer", optimizer);
  averaged_->save(archive, "averaged");
}

void CorrectionTrainee::load(torch::serialize::InputArchive& archive) {
  torch::serialize::InputArchive network, optimizer;
  archive.read("network", network);
  archive.read("optimizer", optimizer);
  network_->load(network);
  optimizer_->load(optimizer);
  averaged_->load(archive, "averaged");
}

}  // namespace posecoach
