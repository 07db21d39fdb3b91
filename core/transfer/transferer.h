// Draws a pose in another person's proportions, from pictures alone.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/transfer/pose2d.h"

namespace posecoach {

// scale:   the pose as it is, scaled to the other person's box height.
// bones:   the pose's 2D bone directions with the longest 2D bone lengths seen of the other person.
// ratio:   each 2D bone times the ratio of the two people's true lengths, so that its foreshortening stays.
// paper:   the network of Zheng et al. (2021).
// network: ours, a learned correction of `ratio`.
enum class TransferMethod { Scale, Bones, Ratio, Paper, Network };
inline constexpr std::array<TransferMethod, 5> kTransferMethods = {
    TransferMethod::Scale, TransferMethod::Bones, TransferMethod::Ratio, TransferMethod::Paper,
    TransferMethod::Network};
std::string_view to_string(TransferMethod method);
Result<TransferMethod> transfer_method_from_string(std::string_view name);

// Joints that are expected to be further off than this are said to be, and not drawn as if known; in
// statures.
inline constexpr double kFarOff = 0.08;

struct TransferredPose {
  Pose2d pose;  // in the units of the identity's pictures, the mid-hip at the origin; all joints "seen"
  // How far each joint is expected to be off, as a fraction of the person's stature; negative: not known.
  std::array<double, kJoint2dCount> expected_error;
  std::vector<std::string> doubts;  // what could not be known and was guessed, in plain words
};

// Two people, then poses. Not for several threads at once.
class Transferer {
 public:
  virtual ~Transferer() = default;
  // `source`: pictures of the person who poses, at one scale (a film of them; at the least the pose itself).
  // `identity`: pictures of the person to be drawn, at one scale. Errors: Incomplete when either shows
  // nobody.
  virtual Result<void> set_people(std::span<const Pose2d> source, std::span<const Pose2d> identity) = 0;
  // After set_people only. `pose` is at the scale of the source's pictures.
  virtual TransferredPose transfer(const Pose2d& pose) = 0;
};

}  // namespace posecoach
