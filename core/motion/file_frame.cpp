#include "core/motion/file_frame.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "core/base/assert.h"
#include "core/base/index.h"
#include "core/body/two_bone_ik.h"

namespace posecoach {
namespace {

constexpr double kStaturePerLegAndTrunk = 1.0 / (0.491 + 0.288);  // of the standard body
constexpr double kMostArmDeviation = radians_from_degrees(25);
constexpr double kMostLegDeviation = radians_from_degrees(18);

// A file's joints with their rest positions, by role.
class RestPose {
 public:
  explicit RestPose(std::span<const Joint> joints) : joints_(joints) {
    by_role_.fill(kNoJoint);
    for (std::size_t j = 0; j < joints.size(); ++j) {
      positions_.push_back(joints[j].offset);
      if (joints[j].parent != kNoJoint) positions_.back() += positions_[index(joints[j].parent)];
      if (joints[j].role) by_role_[static_cast<std::size_t>(*joints[j].role)] = static_cast<int>(j);
    }
  }

  int find(HumanoidJoint role) const { return by_role_[static_cast<std::size_t>(role)]; }
  bool has(HumanoidJoint role) const { return find(role) != kNoJoint; }
  const Vec3& at(HumanoidJoint role) const { return positions_[index(find(role))]; }
  // The mean of two joints that both exist.
  std::optional<Vec3> middle(HumanoidJoint a, HumanoidJoint b) const {
    if (!has(a) || !has(b)) return std::nullopt;
    return (at(a) + at(b)) / 2.0;
  }
  std::optional<Vec3> between(HumanoidJoint from, HumanoidJoint to) const {
    if (!has(from) || !has(to) || at(from) == at(to)) return std::nullopt;
    return at(to) - at(from);
  }
  // Along the bones from an ancestor to a joint; 0 where one of them is missing.
  double chain_length(HumanoidJoint from, HumanoidJoint to) const {
    if (!has(from) || !has(to)) return 0;
    double length = 0;
    int joint = find(to);
    for (; joint != find(from) && joints_[index(joint)].parent != kNoJoint;
         joint = joints_[index(joint)].parent)
      length += glm::length(joints_[index(joint)].offset);
    return joint == find(from) ? length : 0;
  }
  double largest_extent() const {
    Vec3 low = positions_.front(), high = low;
    for (const Vec3& p : positions_) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    return std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  }

 private:
  std::span<const Joint> joints_;
  std::vector<Vec3> positions_;
  std::array<int, kHumanoidJointCount> by_role_{};
};

// Along the chains, so that it does not depend on how the rest pose stands.
double stature(const RestPose& rest) {
  using enum HumanoidJoint;
  const double leg = std::max(rest.chain_length(LeftHip, LeftAnkle), rest.chain_length(RightHip, RightAnkle));
  const double trunk = std::max(rest.chain_length(Pelvis, Neck), rest.chain_length(Pelvis, Chest));
  if (leg <= 0 || trunk <= 0) return rest.largest_extent();
  return (leg + trunk) * kStaturePerLegAndTrunk;
}

bool has_hand_bones(std::span<const Joint> joints) {
  return std::any_of(joints.begin(), joints.end(), [](const Joint& joint) {
    return joint.name.find("HandThumb1") != std::string::npos ||
           joint.name.find("HandIndex1") != std::string::npos || joint.name.starts_with("mixamorig");
  });
}

struct Unit {
  double metres;
  double shortest, tallest;  // people, in this unit
};
constexpr std::array kUnits = {Unit{1.0, 0.25, 4},     Unit{0.3048, 4, 8},   Unit{0.1, 8, 20},
                               Unit{0.056444, 20, 45}, Unit{0.0254, 45, 85}, Unit{0.01, 85, 450},
                               Unit{0.001, 450, 4500}};

double metres_per_unit(double height, bool is_decimal) {
  // Rigs with finger bones under these names come from programs that write metres or centimetres; their
  // figures may be children or cartoons.
  if (is_decimal) return height < 4 ? 1.0 : height < 450 ? 0.01 : 0.001;
  for (const Unit& unit : kUnits)
    if (height >= unit.shortest && height < unit.tallest) return unit.metres;
  return 1.75 / height;  // no unit of people: a doll or a giant, brought to a person's size
}

Vec3 snapped_to_axis(const Vec3& v) {
  const Vec3 size = glm::abs(v);
  if (size.x >= size.y && size.x >= size.z) return {v.x < 0 ? -1 : 1, 0, 0};
  if (size.y >= size.z) return {0, v.y < 0 ? -1 : 1, 0};
  return {0, 0, v.z < 0 ? -1 : 1};
}

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// Nothing when the rest pose does not stand: then legs and trunk do not point opposite ways.
std::optional<Vec3> rest_up(const RestPose& rest) {
  using enum HumanoidJoint;
  const auto hips = rest.middle(LeftHip, RightHip), ankles = rest.middle(LeftAnkle, RightAnkle);
  const HumanoidJoint top = rest.has(Neck) ? Neck : Chest;
  if (!hips || !ankles || !rest.has(top)) return std::nullopt;
  const Vec3 trunk = rest.at(top) - *hips, legs = *hips - *ankles;
  if (glm::length(trunk) <= 0 || glm::length(legs) <= 0 ||
      angle_between(trunk, legs) > radians_from_degrees(60))
    return std::nullopt;
  return trunk + legs;
}

std::optional<Vec3> rest_left(const RestPose& rest) {
  using enum HumanoidJoint;
  const auto shoulders = rest.between(RightShoulder, LeftShoulder);
  return shoulders ? shoulders : rest.between(RightHip, LeftHip);
}

// Quarter turns that bring the rest pose to stand along +Y with its left towards +X.
Quat rest_axes(const RestPose& rest) {
  const auto up = rest_up(rest);
  const auto left = rest_left(rest);
  if (!up || !left) return {1, 0, 0, 0};
  const Vec3 y = snapped_to_axis(*up);
  const Vec3 x = snapped_to_axis(*left - y * glm::dot(*left, y));
  if (std::abs(glm::dot(x, y)) > 0.5) return {1, 0, 0, 0};
  const Mat3 file_from_rest(x, y, glm::cross(x, y));
  return glm::normalize(glm::conjugate(glm::quat_cast(file_from_rest)));
}

// Turns one limb straight when it stands too far from the T-pose; what hangs below the joint that ends it
// turns along, or keeps its own stand (feet).
struct LimbRule {
  std::array<HumanoidJoint, 3> joints;
  Vec3 direction;
  double most_deviation;
  bool end_turns_along;
};

std::vector<Quat> rest_rotations(std::span<const Joint> joints, const RestPose& rest) {
  using enum HumanoidJoint;
  const Quat axes = rest_axes(rest);
  std::vector<Quat> rotations(joints.size(), axes);
  if (!rest_up(rest)) return rotations;
  const std::array rules = {
      LimbRule{{LeftShoulder, LeftElbow, LeftWrist}, {1, 0, 0}, kMostArmDeviation, true},
      LimbRule{{RightShoulder, RightElbow, RightWrist}, {-1, 0, 0}, kMostArmDeviation, true},
      LimbRule{{LeftHip, LeftKnee, LeftAnkle}, {0, -1, 0}, kMostLegDeviation, false},
      LimbRule{{RightHip, RightKnee, RightAnkle}, {0, -1, 0}, kMostLegDeviation, false}};
  std::vector<bool> set(joints.size(), false);
  for (const LimbRule& rule : rules) {
    const auto upper = rest.between(rule.joints[0], rule.joints[1]),
               lower = rest.between(rule.joints[1], rule.joints[2]);
    if (!upper || !lower || angle_between(axes * (*upper + *lower), rule.direction) <= rule.most_deviation)
      continue;
    const Quat first = swing_between(axes * *upper, rule.direction) * axes;
    const Quat second = swing_between(first * *lower, rule.direction) * first;
    const std::array turns = {first, second, rule.end_turns_along ? second : axes};
    for (std::size_t i = 0; i < turns.size(); ++i) {
      const auto joint = index(rest.find(rule.joints[i]));
      rotations[joint] = turns[i];
      set[joint] = true;
    }
  }
  for (std::size_t j = 1; j < joints.size(); ++j)
    if (!set[j]) rotations[j] = rotations[index(joints[j].parent)];
  return rotations;
}

}  // namespace

double metres_per_unit_of_person(double length) {
  return metres_per_unit(length * kStaturePerLegAndTrunk, false);
}

Quat rotation_to_y_up(const Vec3& up) {
  const Vec3 axis = snapped_to_axis(up);
  if (axis.y > 0) return {1, 0, 0, 0};
  if (axis.y < 0) return {0, 1, 0, 0};  // half a turn about x
  return glm::angleAxis(kPi / 2, glm::cross(axis, Vec3(0, 1, 0)));
}

Result<FileFrame> file_frame(std::span<const Joint> joints) {
  POSECOACH_ASSERT(!joints.empty());
  const RestPose rest(joints);
  const double height = stature(rest);
  if (!(height > 1e-6) || !(height < 1e9))
    return fail(ErrorCode::Malformed,
                "the joints' offsets do not make a body: it is " + std::to_string(height) + " units high");
  FileFrame frame;
  frame.metres_per_unit = metres_per_unit(height, has_hand_bones(joints));
  frame.rest_from_file = rest_rotations(joints, rest);
  frame.world_from_file = rotation_to_y_up(rest_up(rest).value_or(Vec3(0, 1, 0)));
  return frame;
}

std::vector<Joint> converted(std::vector<Joint> joints, const FileFrame& frame) {
  POSECOACH_ASSERT(frame.rest_from_file.size() == joints.size());
  for (Joint& joint : joints) {
    const Quat& turn =
        joint.parent == kNoJoint ? frame.rest_from_file[0] : frame.rest_from_file[index(joint.parent)];
    joint.offset = turn * joint.offset * frame.metres_per_unit;
  }
  return joints;
}

}  // namespace posecoach
