// A body's joints as a tree in rest pose (T-pose: arms level to the sides, palms down, facing +Z, up +Y),
// metres. Valid by construction: one root at index 0, parents before children, finite offsets, unique names.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/body/humanoid.h"

namespace posecoach {

inline constexpr int kNoJoint = -1;

struct Joint {
  std::string name;
  int parent = kNoJoint;
  Vec3 offset;  // from the parent, rest pose, world axes, metres; the root's own rest position
  std::optional<HumanoidJoint> role;  // which canonical joint this is, if any; each role at most once
};

class Skeleton {
 public:
  // Errors: Malformed naming the joint (no joints, a child before its parent, two roots, duplicate names or
  // roles, an offset that is not finite).
  static Result<Skeleton> make(std::vector<Joint> joints);

  int size() const { return static_cast<int>(joints_.size()); }
  const Joint& joint(int index) const { return joints_[static_cast<std::size_t>(index)]; }
  std::span<const Joint> joints() const { return joints_; }
  std::span<const int> children(int index) const { return children_[static_cast<std::size_t>(index)]; }

  // kNoJoint when there is none.
  int find(std::string_view name) const;
  int find(HumanoidJoint role) const { return by_role_[static_cast<std::size_t>(role)]; }
  bool has(HumanoidJoint role) const { return find(role) != kNoJoint; }

  // World positions of the rest pose with the root at its own offset.
  std::span<const Vec3> rest_positions() const { return rest_positions_; }
  double bone_length(int index) const;

  // From the lowest to the highest joint of the rest pose, metres. Not the stature: there is no flesh.
  double rest_height() const;
  // Leg length: hip to knee to ankle, mean of both sides; 0 where legs are missing. The scale of a root's
  // path.
  double leg_length() const;

  Skeleton scaled(double factor) const;
  bool operator==(const Skeleton& other) const;

 private:
  explicit Skeleton(std::vector<Joint> joints);

  std::vector<Joint> joints_;
  std::vector<std::vector<int>> children_;
  std::array<int, kHumanoidJointCount> by_role_{};
  std::vector<Vec3> rest_positions_;
};

}  // namespace posecoach
