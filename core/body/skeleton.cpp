#include "core/body/skeleton.h"

#include <algorithm>
#include <set>

#include <glm/geometric.hpp>

namespace posecoach {

Result<Skeleton> Skeleton::make(std::vector<Joint> joints) {
  if (joints.empty()) return fail(ErrorCode::Malformed, "a skeleton needs at least one joint");
  std::set<std::string_view> names;
  std::set<HumanoidJoint> roles;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Joint& joint = joints[i];
    if (i == 0 && joint.parent != kNoJoint)
      return fail(ErrorCode::Malformed, "the first joint, " + joint.name + ", must be the root");
    if (i > 0 && joint.parent == kNoJoint)
      return fail(ErrorCode::Malformed, "a skeleton has one root, but " + joint.name + " has no parent");
    if (i > 0 && (joint.parent < 0 || joint.parent >= static_cast<int>(i)))
      return fail(ErrorCode::Malformed, "joint " + joint.name + " stands before its parent");
    if (!names.insert(joint.name).second)
      return fail(ErrorCode::Malformed, "two joints are called " + joint.name);
    if (!is_finite(joint.offset))
      return fail(ErrorCode::Malformed, "the offset of " + joint.name + " is not finite");
    if (joint.role && !roles.insert(*joint.role).second)
      return fail(ErrorCode::Malformed, "two joints stand for " + std::string(to_string(*joint.role)));
  }
  return Skeleton(std::move(joints));
}

Skeleton::Skeleton(std::vector<Joint> joints) : joints_(std::move(joints)) {
  by_role_.fill(kNoJoint);
  children_.resize(joints_.size());
  rest_positions_.resize(joints_.size());
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Joint& joint = joints_[i];
    if (joint.role) by_role_[static_cast<std::size_t>(*joint.role)] = static_cast<int>(i);
    rest_positions_[i] = joint.offset;
    if (joint.parent != kNoJoint) {
      children_[static_cast<std::size_t>(joint.parent)].push_back(static_cast<int>(i));
      rest_positions_[i] += rest_positions_[static_cast<std::size_t>(joint.parent)];
    }
  }
}

int Skeleton::find(std::string_view name) const {
  const auto found =
      std::find_if(joints_.begin(), joints_.end(), [&](const Joint& j) { return j.name == name; });
  return found == joints_.end() ? kNoJoint : static_cast<int>(found - joints_.begin());
}

double Skeleton::bone_length(int index) const {
  return joint(index).parent == kNoJoint ? 0.0 : glm::length(joint(index).offset);
}

double Skeleton::rest_height() const {
  const auto [low, high] = std::minmax_element(rest_positions_.begin(), rest_positions_.end(),
                                               [](const Vec3& a, const Vec3& b) { return a.y < b.y; });
  return high->y - low->y;
}

double Skeleton::leg_length() const {
  using enum HumanoidJoint;
  double sum = 0;
  int legs = 0;
  for (const auto& [hip, knee, ankle] :
       {std::array{LeftHip, LeftKnee, LeftAnkle}, std::array{RightHip, RightKnee, RightAnkle}}) {
    if (!has(hip) || !has(knee) || !has(ankle)) continue;
    const auto at = [&](HumanoidJoint role) { return rest_positions_[static_cast<std::size_t>(find(role))]; };
    sum += glm::distance(at(hip), at(knee)) + glm::distance(at(knee), at(ankle));
    ++legs;
  }
  return legs == 0 ? 0.0 : sum / legs;
}

Skeleton Skeleton::scaled(double factor) const {
  std::vector<Joint> joints = joints_;
  for (Joint& joint : joints) joint.offset *= factor;
  return Skeleton(std::move(joints));
}

bool Skeleton::operator==(const Skeleton& other) const {
  return std::equal(joints_.begin(), joints_.end(), other.joints_.begin(), other.joints_.end(),
                    [](const Joint& a, const Joint& b) {
                      return a.name == b.name && a.parent == b.parent && a.offset == b.offset &&
                             a.role == b.role;
                    });
}

}  // namespace posecoach
