// A T-pose body measured from joint positions over many frames: where a source has positions only (markers,
// a webcam), bone lengths are medians over the frames and directions are those of the standard body.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/body/skeleton.h"

namespace posecoach {

// A joint to be measured: a Joint whose offset is not known yet.
struct MeasuredJoint {
  std::string name;
  int parent = kNoJoint;  // parents before children, the root first
  HumanoidJoint role = HumanoidJoint::Pelvis;
};

// `positions` (metres, any world frame, any posture) and `confidence` (in [0, 1], or empty for 1 everywhere)
// are frame-major: element frame * joints.size() + joint. A bone's length is the median over the frames,
// weighted by the lower confidence of its two ends, and the mean of left and right. The lowest joint of the
// T-pose stands on the floor. Errors: Incomplete (no frames; a bone that was never seen, named), Malformed
// (parents that do not make a tree).
Result<Skeleton> measure_skeleton(std::span<const MeasuredJoint> joints, std::span<const Vec3> positions,
                                  std::span<const double> confidence = {});

}  // namespace posecoach
