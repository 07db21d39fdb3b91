#include "core/transfer/network/trained_transferers.h"

#include <omp.h>

#include <algorithm>
#include <sstream>

#include "core/base/assert.h"
#include "core/transfer/bone_lengths.h"
#include "core/transfer/doubts.h"
#include "core/transfer/evaluation.h"
#include "core/transfer/touching_hands.h"
#include "core/transfer/trained.h"

namespace posecoach {
namespace {

// Both people's measured bones, which every trained transfer needs.
struct People {
  BoneLengths2d source, identity;
};

Result<People> measure_people(std::span<const Pose2d> source, std::span<const Pose2d> identity) {
  const Result<BoneLengths2d> from = measure_bone_lengths(source), to = measure_bone_lengths(identity);
  if (!from) return fail(from.error().code, "the pose's pictures: " + from.error().message);
  if (!to) return fail(to.error().code, "the identity's pictures: " + to.error().message);
  return People{*from, *to};
}

// The paper's network knows no missing joints: they hang from their parents.
Pose2d completed(const Pose2d& pose, double stature) {
  if (pose.is_complete()) return pose;
  const Pose2d whole = bridged(pose);
  std::array<Vec2, kBone2dCount> bones;
  for (std::size_t b = 0; b < kBone2dCount; ++b)
    bones[b] = bone_vector(whole, b).value_or(guessed_bone(b) * stature);
  return pose_from_bones(bones, pose.is_seen(Joint2d::MidHip) ? pose[Joint2d::MidHip] : Vec2{});
}

Pose2d pose_from_tensor(const torch::Tensor& joints, double scale) {
  const torch::Tensor values = joints.contiguous();
  const float* p = values.data_ptr<float>();
  Pose2d pose;
  pose.seen.fill(true);
  for (std::size_t i = 0; i < kJoint2dCount; ++i)
    pose.positions[i] = scale * Vec2{double(p[2 * i]), double(p[2 * i + 1])};
  return translated(pose, -pose[Joint2d::MidHip]);
}

class PaperTransferer : public Transferer {
 public:
  explicit PaperTransferer(std::shared_ptr<PaperTransferGenerator> generator)
      : generator_(std::move(generator)) {}

  Result<void> set_people(std::span<const Pose2d> source, std::span<const Pose2d> identity) override {
    const Result<People> people = measure_people(source, identity);
    if (!people) return tl::unexpected(people.error());
    people_ = *people;
    source_scale_ = kPaperUnitsPerMetre * kPaperStature_m / people_.source.stature;
    identity_scale_ = kPaperUnitsPerMetre * kPaperStature_m / people_.identity.stature;
    const torch::InferenceMode inference;
    std::vector<torch::Tensor> pictures;
    for (const Pose2d& picture : identity)
      pictures.push_back(paper_tensor(completed(picture, people_.identity.stature), identity_scale_));
    code_ = generator_->encode_identity(torch::stack(pictures).unsqueeze(0));
    return {};
  }

  TransferredPose transfer(const Pose2d& pose) override {
    const torch::InferenceMode inference;
    const torch::Tensor input =
        paper_tensor(completed(pose, people_.source.stature), source_scale_).unsqueeze(0);
    const torch::Tensor output = generator_->decode(generator_->encode_pose(input), code_);
    TransferredPose result;
    result.pose = pose_from_tensor(output[0], 1 / identity_scale_);
    result.expected_error.fill(-1);
    result.doubts = doubts_about(pose, result, people_.source, people_.identity);
    return result;
  }

 private:
  std::shared_ptr<PaperTransferGenerator> generator_;
  People people_;
  double source_scale_ = 1, identity_scale_ = 1;
  torch::Tensor code_;
};

// The network sees everything twice, as it is and in a mirror, and the two answers' mean counts: so a
// left-handed pose gets exactly the mirrored answer of a right-handed one.
class NetworkTransferer : public Transferer {
 public:
  explicit NetworkTransferer(std::shared_ptr<TransferNetwork> network) : network_(std::move(network)) {}

  Result<void> set_people(std::span<const Pose2d> source, std::span<const Pose2d> identity) override {
    const Result<People> people = measure_people(source, identity);
    if (!people) return tl::unexpected(people.error());
    people_ = *people;
    const torch::InferenceMode inference;
    source_ = encode(source, people_.source);
    identity_ = encode(identity, people_.identity);
    return {};
  }

  TransferredPose transfer(const Pose2d& pose) override {
    const torch::InferenceMode inference;
    torch::Tensor pictures = torch::empty({2, kPictureNumbers});
    const Pose2d whole = bridged(pose);
    write_picture(whole, people_.source.stature, pictures.data_ptr<float>());
    write_picture(mirrored(whole), people_.source.stature, pictures.data_ptr<float>() + kPictureNumbers);
    const TransferNetwork::Result answer = network_->forward(pictures, source_, identity_);
    const torch::Tensor joints = joints_from_bones(answer.bones);
    TransferredPose result;
    result.pose = pose_from_tensor(joints[0], people_.identity.stature);
    const Pose2d other = mirrored(pose_from_tensor(joints[1], people_.identity.stature));
    for (std::size_t i = 0; i < kJoint2dCount; ++i) {
      result.pose.positions[i] = 0.5 * (result.pose.positions[i] + other.positions[i]);
      const std::size_t twin = index(mirrored(static_cast<Joint2d>(i)));
      result.expected_error[i] = 0.5 * (answer.expected_error[0][static_cast<int64_t>(i)].item<double>() +
                                        answer.expected_error[1][static_cast<int64_t>(twin)].item<double>());
    }
    // Sure enough of a touch: all of it; below one half: nothing.
    const double touch = torch::sigmoid(answer.touch.mean()).item<double>();
    keep_hands_together(result.pose, pose, people_.identity.stature / people_.source.stature,
                        std::clamp(4 * touch - 2, 0.0, 1.0));
    result.doubts = doubts_about(pose, result, people_.source, people_.identity);
    return result;
  }

 private:
  TransferNetwork::Person encode(std::span<const Pose2d> pictures, const BoneLengths2d& lengths) {
    const std::size_t row = static_cast<std::size_t>(kPictureNumbers);
    torch::Tensor numbers = torch::empty({2, static_cast<int64_t>(pictures.size()), kPictureNumbers});
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      write_picture(pictures[i], lengths.stature, numbers.data_ptr<float>() + i * row);
      write_picture(mirrored(pictures[i]), lengths.stature,
                    numbers.data_ptr<float>() + (pictures.size() + i) * row);
    }
    // Lengths count both sides as one, so they are the same in the mirror.
    torch::Tensor person = torch::empty({2, kPersonNumbers});
    write_person(lengths, person.data_ptr<float>());
    write_person(lengths, person.data_ptr<float>() + kPersonNumbers);
    return network_->encode(numbers, person);
  }

  std::shared_ptr<TransferNetwork> network_;
  People people_;
  TransferNetwork::Person source_, identity_;
};

}  // namespace

torch::Tensor paper_tensor(const Pose2d& pose, double units_per_unit) {
  const Pose2d in_units = scaled(centred(pose), units_per_unit);
  torch::Tensor tensor = torch::empty({static_cast<int64_t>(kJoint2dCount), 2});
  float* out = tensor.data_ptr<float>();
  for (const Vec2& p : in_units.positions) {
    *out++ = static_cast<float>(p.x);
    *out++ = static_cast<float>(p.y);
  }
  return tensor;
}

std::unique_ptr<Transferer> make_paper_transferer(std::shared_ptr<PaperTransferGenerator> generator) {
  return std::make_unique<PaperTransferer>(std::move(generator));
}

std::unique_ptr<Transferer> make_network_transferer(std::shared_ptr<TransferNetwork> network) {
  return std::make_unique<NetworkTransferer>(std::move(network));
}

std::string transfer_weights_of(const torch::nn::Module& module, std::string_view kind) {
  torch::serialize::OutputArchive archive;
  archive.write("kind", c10::IValue(std::string(kind)));
  module.save(archive);
  std::ostringstream stream;
  archive.save_to(stream);
  return stream.str();
}

Result<void> read_transfer_weights(torch::nn::Module& module, std::string_view weights, std::string_view name,
                                   std::string_view kind) {
  try {
    std::istringstream stream{std::string(weights)};
    torch::serialize::InputArchive archive;
    archive.load_from(stream);
    c10::IValue found;
    if (!archive.try_read("kind", found) || !found.isString() || found.toStringRef() != kind)
      return fail(ErrorCode::Malformed, std::string(name) + ": not the weights of " + std::string(kind));
    module.load(archive);
    module.eval();
    return {};
  } catch (const std::exception&) {
    return fail(ErrorCode::Malformed, std::string(name) + ": these weights cannot be read; train them again");
  }
}

double transfer_average_keeps(long iteration) {
  return std::min(0.999, static_cast<double>(iteration + 1) / static_cast<double>(iteration + 10));
}

void move_transfer_average(torch::nn::Module& average, const torch::nn::Module& current, double keep) {
  const torch::NoGradGuard no_grad;
  const std::vector<torch::Tensor> to = average.parameters(), from = current.parameters();
  for (std::size_t i = 0; i < to.size(); ++i) {
    torch::Tensor target = to[i];
    target.lerp_(from[i], 1 - keep);
  }
}

void use_one_core_for_transfer() {
  omp_set_num_threads(1);
  at::set_num_threads(1);
  at::globalContext().setFlushDenormal(true);
}

Result<std::unique_ptr<Transferer>> load_transferer(TransferMethod method, std::string_view weights,
                                                    std::string_view name) {
  POSECOACH_ASSERT(method == TransferMethod::Paper || method == TransferMethod::Network);
  use_one_core_for_transfer();
  if (method == TransferMethod::Paper) {
    auto generator = std::make_shared<PaperTransferGenerator>();
    if (Result<void> read = read_transfer_weights(*generator, weights, name, kPaperKind); !read)
      return tl::unexpected(read.error());
    return make_paper_transferer(std::move(generator));
  }
  auto network = std::make_shared<TransferNetwork>();
  if (Result<void> read = read_transfer_weights(*network, weights, name, kNetworkKind); !read)
    return tl::unexpected(read.error());
  return make_network_transferer(std::move(network));
}

}  // namespace posecoach
