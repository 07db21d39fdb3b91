// How long a person's bones are, as far as pictures at one scale show it.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "core/base/error.h"
#include "core/transfer/pose2d.h"

namespace posecoach {

struct BoneLengths2d {
  std::array<double, kBone2dCount> length{};  // never zero
  std::array<bool, kBone2dCount> measured{};  // false: from the average person's proportions
  double stature = 0;                         // of an average person with these bones, same unit
};

// The 95th percentile of each bone's length in the pictures: a bone is seen at its true length when it lies
// across the view, and never longer. Left and right count as one bone seen twice. Errors: Incomplete when no
// picture shows a bone of any length.
Result<BoneLengths2d> measure_bone_lengths(std::span<const Pose2d> pictures);

}  // namespace posecoach
