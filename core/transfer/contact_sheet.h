// A sheet of transfers to look at: the pose, the person, and the pose on that person, side by side.
#pragma once

#include <span>

#include "core/base/error.h"
#include "core/transfer/transferer.h"

namespace posecoach {

struct SheetRow {
  Pose2d pose;
  Pose2d identity;
  TransferredPose result;
  std::optional<Pose2d> truth;  // drawn in grey under the result
};

// A PNG's bytes. Joints that were guessed (not seen in the pose, or expected to be far off) are drawn hollow,
// their bones grey. Every figure fills its cell; identity and result of a row share one scale.
std::string contact_sheet_png(std::span<const SheetRow> rows);

}  // namespace posecoach
