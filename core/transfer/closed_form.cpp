#include "core/transfer/closed_form.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/transfer/bone_lengths.h"
#include "core/transfer/doubts.h"

namespace posecoach {
namespace {

class ClosedFormTransferer : public Transferer {
 public:
  explicit ClosedFormTransferer(TransferMethod method) : method_(method) {}

  Result<void> set_people(std::span<const Pose2d> source, std::span<const Pose2d> identity) override {
    const Result<BoneLengths2d> from = measure_bone_lengths(source), to = measure_bone_lengths(identity);
    if (!from) return fail(from.error().code, "the pose's pictures: " + from.error().message);
    if (!to) return fail(to.error().code, "the identity's pictures: " + to.error().message);
    source_ = *from;
    identity_ = *to;
    identity_height_ = 0;
    for (const Pose2d& picture : identity)
      identity_height_ += bounding_box(picture).size().y / double(identity.size());
    return {};
  }

  TransferredPose transfer(const Pose2d& pose) override {
    std::array<Vec2, kBone2dCount> bones;
    const Pose2d whole = bridged(pose);
    const double pose_height = bounding_box(pose).size().y;
    const double same_size = identity_.stature / source_.stature;
    for (std::size_t b = 0; b < kBone2dCount; ++b) {
      const std::optional<Vec2> seen = bone_vector(whole, b);
      if (!seen) {
        bones[b] = guessed_bone(b) * identity_.stature;
        continue;
      }
      const double length = glm::length(*seen);
      switch (method_) {
        case TransferMethod::Scale:
          bones[b] = *seen * (pose_height > 0 ? identity_height_ / pose_height : same_size);
          break;
        case TransferMethod::Bones:
          bones[b] = length > 0 ? *seen * (identity_.length[b] / length) : Vec2{};
          break;
        default:
          bones[b] = *seen * ratio(b);
      }
    }
    TransferredPose result;
    result.pose = pose_from_bones(bones, {});
    result.expected_error.fill(-1);
    result.doubts = doubts_about(pose, result, source_, identity_);
    return result;
  }

 private:
  // A bone that only one of the two people showed says nothing about their ratio.
  double ratio(std::size_t b) const {
    if (source_.measured[b] && identity_.measured[b]) return identity_.length[b] / source_.length[b];
    return identity_.stature / source_.stature;
  }

  TransferMethod method_;
  BoneLengths2d source_, identity_;
  double identity_height_ = 0;
};

}  // namespace

std::unique_ptr<Transferer> make_closed_form_transferer(TransferMethod method) {
  POSECOACH_ASSERT(method == TransferMethod::Scale || method == TransferMethod::Bones ||
                   method == TransferMethod::Ratio);
  return std::make_unique<ClosedFormTransferer>(method);
}

}  // namespace posecoach
