// Which labels make which joint.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/body/humanoid.h"

namespace posecoach {

// The mean of some markers is a joint.
struct MarkerJoint {
  HumanoidJoint role;
  std::vector<std::size_t> markers;
};

// Where hip joints lie relative to the waist markers, in units of the breadth between the two front (or side)
// ones, from their middle.
struct HipEstimate {
  std::size_t left = 0, right = 0;  // front or side of the waist
  std::vector<std::size_t> back;
  double sideways = 0, down = 0, back_by = 0;
};

struct MarkerBody {
  std::vector<MarkerJoint> joints;  // each role once
  std::vector<HipEstimate> hips;    // at most one
};

MarkerBody find_marker_joints(std::span<const std::string> labels);

}  // namespace posecoach
