#include "core/motion/rig.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <initializer_list>

#include "core/base/index.h"
#include "core/motion/short_list.h"

namespace posecoach {
namespace {

using Names = std::initializer_list<std::string_view>;

// In order of preference: where a rig has several, the first is the point itself.
constexpr auto kHipNames = {"upleg", "thigh", "upperleg", "femur", "hip"};
constexpr auto kKneeNames = {"knee", "shin", "calf", "lowerleg", "lowleg", "tibia", "leg"};
constexpr auto kAnkleNames = {"ankle", "foot"};
constexpr auto kToeNames = {"toebase", "toe", "toes", "ball", "toe0", "footindex", "forefoot"};
constexpr auto kToeTipNames = {"toeend",  "toetip",  "toesend", "toebaseend", "toenub",
                               "toe0nub", "toe0end", "ballend", "toesite",    "toetipend"};
constexpr auto kCollarNames = {"clavicle", "collar", "collarbone", "clav"};
constexpr auto kUpperArmNames = {"upperarm", "uparm", "arm", "shldr", "humerus"};
constexpr auto kElbowNames = {"forearm", "lowerarm", "lowarm", "elbow", "radius"};
constexpr auto kWristNames = {"wrist", "hand"};
constexpr auto kHeadTopNames = {"headtopend", "headtop", "headend", "headnub", "headtip", "topofhead"};

struct Limb {
  int first = kNoJoint, second = kNoJoint, third = kNoJoint, fourth = kNoJoint, fifth = kNoJoint;
};

class RoleMapper {
 public:
  // Without joints there is no tree: names alone count.
  explicit RoleMapper(std::span<const std::string_view> names, std::span<const Joint> joints = {})
      : joints_(joints), names_(parse_rig_names(names)), roles_(names.size()) {
    for (const Joint& joint : joints) {
      positions_.push_back(joint.offset);
      if (joint.parent != kNoJoint) positions_.back() += positions_[index(joint.parent)];
    }
    split_glued_sides();
  }

  std::vector<std::optional<HumanoidJoint>> run() {
    using enum HumanoidJoint;
    const Limb left_leg = find_leg(Side::Left), right_leg = find_leg(Side::Right);
    const Limb left_arm = find_arm(Side::Left), right_arm = find_arm(Side::Right);
    if (is_flat())
      name_trunk();
    else
      find_trunk(left_leg, right_leg, left_arm, right_arm);
    assign(left_leg, {LeftHip, LeftKnee, LeftAnkle, LeftToe, LeftToeTip});
    assign(right_leg, {RightHip, RightKnee, RightAnkle, RightToe, RightToeTip});
    assign(left_arm, {LeftClavicle, LeftShoulder, LeftElbow, LeftWrist, {}});
    assign(right_arm, {RightClavicle, RightShoulder, RightElbow, RightWrist, {}});
    if (!is_flat()) find_tips();
    return std::move(roles_);
  }

 private:
  // "lfemur" and "rightupleg" carry their side without any mark.
  void split_glued_sides() {
    for (RigName& name : names_) {
      if (name.side != Side::Middle) continue;
      for (const auto& [mark, side] : {std::pair{"left", Side::Left}, std::pair{"right", Side::Right},
                                       std::pair{"l", Side::Left}, std::pair{"r", Side::Right}}) {
        const std::string_view text = mark;
        if (name.base.starts_with(text) && is_sided_name(name.base.substr(text.size()))) {
          name = {side, name.base.substr(text.size())};
          break;
        }
      }
    }
  }
  static bool is_sided_name(std::string_view base) {
    const auto in = [&](const auto& names) {
      return std::find(names.begin(), names.end(), base) != names.end();
    };
    return base == "shoulder" || in(kHipNames) || in(kKneeNames) || in(kAnkleNames) || in(kToeNames) ||
           in(kToeTipNames) || in(kCollarNames) || in(kUpperArmNames) || in(kElbowNames) || in(kWristNames);
  }

  template <typename AllNames>
  int find(Side side, const AllNames& bases) const {
    for (const std::string_view base : bases)
      for (std::size_t j = 0; j < names_.size(); ++j)
        if (names_[j].side == side && names_[j].base == base) return static_cast<int>(j);
    return kNoJoint;
  }
  int parent(int joint) const { return joints_[index(joint)].parent; }
  bool is_flat() const { return joints_.empty(); }
  bool is_above(int ancestor, int joint) const {
    if (is_flat()) return true;
    for (int up = parent(joint); up != kNoJoint; up = parent(up))
      if (up == ancestor) return true;
    return false;
  }
  // A joint that does not hang below its limb's previous joint is another thing of the same name.
  void keep_below(int above, int& joint) const {
    if (above != kNoJoint && joint != kNoJoint && !is_above(above, joint)) joint = kNoJoint;
  }

  Limb find_leg(Side side) const {
    Limb leg;
    leg.first = find(side, kHipNames);
    leg.second = find(side, kKneeNames);
    leg.third = find(side, kAnkleNames);
    leg.fourth = find(side, kToeNames);
    if (leg.fourth == kNoJoint && leg.third != kNoJoint && names_[index(leg.third)].base == "ankle")
      leg.fourth = find(side, Names{"foot"});
    leg.fifth = find(side, kToeTipNames);
    keep_below(leg.first, leg.second);
    keep_below(leg.second, leg.third);
    keep_below(leg.third, leg.fourth);
    keep_below(leg.fourth, leg.fifth);
    return leg;
  }

  Limb find_arm(Side side) const {
    Limb arm;
    arm.first = find(side, kCollarNames);
    arm.second = find(side, kUpperArmNames);
    const int shoulder = find(side, Names{"shoulder"});
    if (arm.second == kNoJoint)
      arm.second = shoulder;
    else if (arm.first == kNoJoint)
      arm.first = shoulder;
    arm.third = find(side, kElbowNames);
    arm.fourth = find(side, kWristNames);
    if (arm.first != kNoJoint && arm.second != kNoJoint && !is_above(arm.first, arm.second))
      arm.first = kNoJoint;
    keep_below(arm.second, arm.third);
    keep_below(arm.third, arm.fourth);
    return arm;
  }

  void name_trunk() {
    using enum HumanoidJoint;
    assign(find(Side::Middle, Names{"pelvis", "hips", "midhip", "hip"}), Pelvis);
    assign(find(Side::Middle, Names{"chest", "thorax", "spine3", "spine2"}), Chest);
    assign(find(Side::Middle, Names{"spine", "abdomen", "lowerback"}), Spine);
    assign(find(Side::Middle, Names{"spinemiddle", "spine1"}), SpineMiddle);
    assign(find(Side::Middle, Names{"neck", "lowerneck"}), Neck);
    assign(find(Side::Middle, Names{"head"}), Head);
    assign(find(Side::Middle, kHeadTopNames), HeadTop);
  }

  int common_ancestor(int a, int b) const {
    if (a == kNoJoint || b == kNoJoint) return kNoJoint;
    while (a != b) (a > b ? a : b) = parent(a > b ? a : b);
    return a;
  }

  void find_trunk(const Limb& left_leg, const Limb& right_leg, const Limb& left_arm, const Limb& right_arm) {
    const auto arm_root = [](const Limb& arm) { return arm.first != kNoJoint ? arm.first : arm.second; };
    const int head = find(Side::Middle, Names{"head"});
    int chest = common_ancestor(arm_root(left_arm), arm_root(right_arm));
    int neck = find(Side::Middle, Names{"neck", "neck1", "neck01", "lowerneck"});
    // 3ds Max hangs the collar bones on the neck.
    if (chest != kNoJoint && names_[index(chest)].base.starts_with("neck")) {
      neck = chest;
      chest = parent(chest);
    }
    const int hips = common_ancestor(left_leg.first, right_leg.first);
    int pelvis = chest == kNoJoint ? hips : common_ancestor(hips, chest);
    if (pelvis != kNoJoint && is_far_from_hips(pelvis, left_leg, right_leg)) {
      const int named = find(Side::Middle, Names{"hips", "pelvis", "hip"});
      if (named != kNoJoint) pelvis = named;
    }
    assign(pelvis, HumanoidJoint::Pelvis);
    if (chest != kNoJoint && chest != pelvis && is_above(pelvis, chest)) assign_spine(pelvis, chest);
    if (head != kNoJoint && chest != kNoJoint && is_above(chest, head)) {
      int first_above_chest = head;
      while (parent(first_above_chest) != chest) first_above_chest = parent(first_above_chest);
      if (first_above_chest != head) neck = first_above_chest;
    }
    if (neck != kNoJoint && (chest == kNoJoint || is_above(chest, neck))) assign(neck, HumanoidJoint::Neck);
    if (head != kNoJoint && (neck == kNoJoint || is_above(neck, head))) assign(head, HumanoidJoint::Head);
  }

  // A "root" between the feet, from which legs and spine both hang, is no pelvis.
  bool is_far_from_hips(int joint, const Limb& left_leg, const Limb& right_leg) const {
    if (left_leg.third == kNoJoint) return false;
    const Vec3 hips = (positions_[index(left_leg.first)] + positions_[index(right_leg.first)]) / 2.0;
    const double leg = glm::distance(positions_[index(left_leg.first)], positions_[index(left_leg.third)]);
    return glm::distance(positions_[index(joint)], hips) > 0.6 * leg;
  }

  void assign_spine(int pelvis, int chest) {
    std::vector<int> spine;  // from the pelvis, exclusive, to the chest
    for (int up = chest; up != pelvis; up = parent(up)) spine.insert(spine.begin(), up);
    assign(chest, HumanoidJoint::Chest);
    if (spine.size() < 2) return;
    assign(spine.front(), HumanoidJoint::Spine);
    if (spine.size() < 3) return;
    const Vec3 middle = (positions_[index(spine.front())] + positions_[index(chest)]) / 2.0;
    const auto nearer = [&](int a, int b) {
      return glm::distance(positions_[index(a)], middle) < glm::distance(positions_[index(b)], middle);
    };
    assign(*std::min_element(spine.begin() + 1, spine.end() - 1, nearer), HumanoidJoint::SpineMiddle);
  }

  void assign(int joint, HumanoidJoint role) {
    if (joint != kNoJoint && !roles_[index(joint)]) roles_[index(joint)] = role;
  }
  void assign(const Limb& limb, const std::array<std::optional<HumanoidJoint>, 5>& roles) {
    const std::array joints = {limb.first, limb.second, limb.third, limb.fourth, limb.fifth};
    for (std::size_t i = 0; i < joints.size(); ++i)
      if (roles[i]) assign(joints[i], *roles[i]);
  }
  int with_role(HumanoidJoint role) const {
    const auto found = std::find(roles_.begin(), roles_.end(), role);
    return found == roles_.end() ? kNoJoint : static_cast<int>(found - roles_.begin());
  }
  bool is_leaf(int joint) const {
    return std::none_of(joints_.begin(), joints_.end(), [&](const Joint& j) { return j.parent == joint; });
  }

  // Points without a name of their own: a leaf below the head, the foot or the toe that points the right way
  // in the rest pose (some exporters write leaves that point anywhere).
  void find_tips() {
    using enum HumanoidJoint;
    const int pelvis = with_role(Pelvis), chest = with_role(Chest);
    if (pelvis == kNoJoint || chest == kNoJoint) return;
    const Vec3 way = positions_[index(chest)] - positions_[index(pelvis)];
    if (glm::length(way) <= 0) return;
    const Vec3 up = glm::normalize(way);
    const int named_top = find(Side::Middle, kHeadTopNames);
    if (with_role(Head) != kNoJoint && named_top != kNoJoint && is_above(with_role(Head), named_top) &&
        rises(named_top, up) > 0.5)
      assign(named_top, HeadTop);
    for (const auto& [ankle, toe, tip] :
         {std::array{LeftAnkle, LeftToe, LeftToeTip}, std::array{RightAnkle, RightToe, RightToeTip}}) {
      if (with_role(toe) == kNoJoint)
        assign(level_leaf(with_role(ankle), up), toe);
      else if (with_role(tip) == kNoJoint)
        assign(level_leaf(with_role(toe), up), tip);
      else if (rises(with_role(tip), up) > 0.6)
        roles_[index(with_role(tip))].reset();
    }
  }
  // The sine of a bone's elevation.
  double rises(int joint, const Vec3& up) const {
    const Vec3& offset = joints_[index(joint)].offset;
    const double length = glm::length(offset);
    return length > 0 ? glm::dot(offset, up) / length : 0.0;
  }
  int level_leaf(int above, const Vec3& up) const {
    if (above == kNoJoint) return kNoJoint;
    for (int j = above + 1; j < static_cast<int>(joints_.size()); ++j)
      if (parent(j) == above && is_leaf(j) && glm::length(joints_[index(j)].offset) > 0 && rises(j, up) < 0.3)
        return j;
    return kNoJoint;
  }

  std::span<const Joint> joints_;
  std::vector<RigName> names_;
  std::vector<Vec3> positions_;
  std::vector<std::optional<HumanoidJoint>> roles_;
};

}  // namespace

std::vector<std::optional<HumanoidJoint>> map_roles(std::span<const Joint> joints) {
  std::vector<std::string_view> names;
  for (const Joint& joint : joints) names.push_back(joint.name);
  return RoleMapper(names, joints).run();
}

std::vector<std::optional<HumanoidJoint>> map_roles_by_name(std::span<const std::string_view> names) {
  return RoleMapper(names).run();
}

Result<void> check_humanoid(const Skeleton& skeleton) {
  using enum HumanoidJoint;
  constexpr std::size_t kMostListed = 8;
  std::vector<std::string> missing, joints;
  const auto need = [&](bool there, std::string_view name) {
    if (!there) missing.emplace_back(name);
  };
  need(skeleton.has(Pelvis), to_string(Pelvis));
  need(skeleton.has(Chest) || skeleton.has(Neck), "chest or neck");
  for (const HumanoidJoint role : {LeftShoulder, LeftElbow, LeftWrist, RightShoulder, RightElbow, RightWrist,
                                   LeftHip, LeftKnee, LeftAnkle, RightHip, RightKnee, RightAnkle})
    need(skeleton.has(role), to_string(role));
  if (missing.empty()) return {};
  for (const Joint& joint : skeleton.joints()) joints.push_back(joint.name);
  return fail(ErrorCode::Incomplete, "this is not a body that can be mapped: no joint was recognised as " +
                                         short_list(missing, missing.size()) + "; the joints are " +
                                         short_list(joints, kMostListed));
}

}  // namespace posecoach
