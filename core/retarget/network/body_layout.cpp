#include "core/retarget/network/body_layout.h"

#include <glm/geometric.hpp>

#include "core/base/assert.h"
#include "core/base/index.h"
#include "core/body/landmark_body.h"
#include "core/body/mirror.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;
using Segments = std::vector<BodySegment>;

class LayoutBuilder {
 public:
  int add(const char* name, int parent, HumanoidJoint first, HumanoidJoint second, Segments segments) {
    joints.push_back({name, parent, first, second, Vec3(0), std::move(segments)});
    return static_cast<int>(joints.size()) - 1;
  }
  int add(const char* name, int parent, HumanoidJoint role, Segments segments) {
    return add(name, parent, role, role, std::move(segments));
  }

  std::vector<LayoutJoint> joints;
};

const Segments kSpineOnly = {BodySegment::Spine};
const Segments kHeadOnly = {BodySegment::Head};
// Head and arms hang on the chest: it belongs to all of them.
const Segments kChestSegments = {BodySegment::Spine, BodySegment::Head, BodySegment::LeftArm,
                                 BodySegment::RightArm};

void add_leg(LayoutBuilder& b, bool left, bool tip, std::array<int, 5>& ends) {
  const Segments leg = {left ? BodySegment::LeftLeg : BodySegment::RightLeg};
  int j = b.add(left ? "left_hip" : "right_hip", 0, left ? LeftHip : RightHip, leg);
  j = b.add(left ? "left_knee" : "right_knee", j, left ? LeftKnee : RightKnee, leg);
  j = b.add(left ? "left_ankle" : "right_ankle", j, left ? LeftAnkle : RightAnkle, leg);
  j = b.add(left ? "left_toe" : "right_toe", j, left ? LeftToe : RightToe, leg);
  if (tip) j = b.add(left ? "left_toe_tip" : "right_toe_tip", j, left ? LeftToeTip : RightToeTip, leg);
  ends[left ? 0 : 1] = j;
}

void add_arm(LayoutBuilder& b, bool left, int chest, bool split, std::array<int, 5>& ends) {
  const Segments arm = {left ? BodySegment::LeftArm : BodySegment::RightArm};
  const HumanoidJoint clavicle = left ? LeftClavicle : RightClavicle;
  const HumanoidJoint shoulder = left ? LeftShoulder : RightShoulder;
  int j = b.add(left ? "left_clavicle" : "right_clavicle", chest, clavicle, arm);
  if (split) j = b.add(left ? "left_clavicle_split" : "right_clavicle_split", j, clavicle, shoulder, arm);
  j = b.add(left ? "left_shoulder" : "right_shoulder", j, shoulder, arm);
  j = b.add(left ? "left_elbow" : "right_elbow", j, left ? LeftElbow : RightElbow, arm);
  j = b.add(left ? "left_wrist" : "right_wrist", j, left ? LeftWrist : RightWrist, arm);
  ends[left ? 3 : 4] = j;
}

void build_mixamo(LayoutBuilder& b, bool split, std::array<int, 5>& ends) {
  b.add("pelvis", kNoJoint, Pelvis, {});
  add_leg(b, true, split, ends);
  add_leg(b, false, split, ends);
  int j = split ? 0 : b.add("hips", 0, Pelvis, kSpineOnly);
  j = b.add("spine", j, Spine, kSpineOnly);
  j = b.add("spine_middle", j, SpineMiddle, kSpineOnly);
  if (split) j = b.add("spine_middle_split", j, SpineMiddle, Chest, kSpineOnly);
  const int chest = b.add("chest", j, Chest, kChestSegments);
  j = b.add("neck", chest, Neck, kHeadOnly);
  j = b.add("head", j, Head, kHeadOnly);
  if (split) j = b.add("head_top", j, HeadTop, kHeadOnly);
  ends[2] = j;
  add_arm(b, true, chest, split, ends);
  add_arm(b, false, chest, split, ends);
}

Segments webcam_segments(int joint) {
  const auto names = landmark_body_joints();
  if (joint == 0) return {};
  const LandmarkJoint& self = names[index(joint)];
  if (self.name == "spine") return kSpineOnly;
  if (self.name == "chest") return kChestSegments;
  const auto landmark = landmark_of_joint(joint);
  if (!landmark || *landmark < Landmark::LeftShoulder) return kHeadOnly;
  const int number = static_cast<int>(*landmark);
  const bool left = number % 2 == 1;  // BlazePose: odd numbers from the shoulders down are left
  if (*landmark < Landmark::LeftHip) return {left ? BodySegment::LeftArm : BodySegment::RightArm};
  return {left ? BodySegment::LeftLeg : BodySegment::RightLeg};
}

// Where a landmark that is no canonical joint sits, in rest heights away from the canonical joint that
// carries it: faces in front of the head, fingers beyond the wrist, heels behind the ankle.
struct Anchor {
  HumanoidJoint role;
  Vec3 offset;
};
std::optional<Anchor> anchor_of(Landmark landmark) {
  switch (landmark) {
    case Landmark::Nose:
      return Anchor{Head, {0, 0.045, 0.075}};
    case Landmark::LeftEyeInner:
      return Anchor{Head, {0.010, 0.065, 0.062}};
    case Landmark::LeftEye:
      return Anchor{Head, {0.018, 0.065, 0.060}};
    case Landmark::LeftEyeOuter:
      return Anchor{Head, {0.026, 0.065, 0.057}};
    case Landmark::LeftEar:
      return Anchor{Head, {0.043, 0.050, 0.005}};
    case Landmark::MouthLeft:
      return Anchor{Head, {0.015, 0.022, 0.062}};
    case Landmark::LeftPinky:
      return Anchor{LeftWrist, {0.053, 0, -0.018}};
    case Landmark::LeftIndex:
      return Anchor{LeftWrist, {0.055, 0, 0.012}};
    case Landmark::LeftThumb:
      return Anchor{LeftWrist, {0.030, -0.008, 0.020}};
    case Landmark::LeftHeel:
      return Anchor{LeftAnkle, {0, -0.030, -0.030}};
    default:
      break;
  }
  const Landmark twin = mirrored(landmark);
  if (twin == landmark || static_cast<int>(twin) > static_cast<int>(landmark)) return {};
  const auto left = anchor_of(twin);
  if (!left) return {};
  return Anchor{mirrored(left->role), mirrored(left->offset)};
}

void build_webcam(LayoutBuilder& b, std::array<int, 5>& ends) {
  const auto names = landmark_body_joints();
  for (int j = 0; j < static_cast<int>(names.size()); ++j) {
    const LandmarkJoint& from = names[index(j)];
    LayoutJoint joint{from.name, from.parent, Pelvis, Pelvis, Vec3(0), webcam_segments(j)};
    if (const auto landmark = landmark_of_joint(j)) {
      if (const auto anchor = anchor_of(*landmark)) {
        joint.first = joint.second = anchor->role;
        joint.offset = anchor->offset;
      } else {
        POSECOACH_ASSERT(from.role.has_value());
        joint.first = joint.second = *from.role;
      }
    } else if (from.name == "pelvis" || from.name == "spine") {
      joint.first = LeftHip, joint.second = RightHip;
    } else if (from.name == "head") {
      joint.first = joint.second = Head;
      joint.offset = {0, 0.050, 0.005};  // between the ears
    } else {
      joint.first = LeftShoulder, joint.second = RightShoulder;
    }
    b.joints.push_back(std::move(joint));
  }
  ends = {landmark_joint(Landmark::LeftFootIndex), landmark_joint(Landmark::RightFootIndex),
          landmark_joint(Landmark::Nose), landmark_joint(Landmark::LeftWrist),
          landmark_joint(Landmark::RightWrist)};
}

}  // namespace

BodyLayout::BodyLayout(BodyLayoutKind kind) : kind_(kind) {
  LayoutBuilder builder;
  if (kind == BodyLayoutKind::Webcam38)
    build_webcam(builder, end_effectors_);
  else
    build_mixamo(builder, kind == BodyLayoutKind::Split28, end_effectors_);
  joints_ = std::move(builder.joints);
}

const BodyLayout& BodyLayout::of(BodyLayoutKind kind) {
  static const std::array layouts = {BodyLayout(BodyLayoutKind::Split28),
                                     BodyLayout(BodyLayoutKind::OldRig23),
                                     BodyLayout(BodyLayoutKind::Webcam38)};
  return layouts[static_cast<std::size_t>(kind)];
}

std::vector<int> BodyLayout::joints_of(BodySegment segment) const {
  std::vector<int> found;
  for (int j = 0; j < size(); ++j)
    for (const BodySegment s : joints_[index(j)].segments)
      if (s == segment) found.push_back(j);
  return found;
}

void BodyLayout::place(const RoleArray<Vec3>& positions, const RoleArray<Quat>& turns, double scale,
                       std::span<Vec3> out) const {
  POSECOACH_ASSERT(out.size() == joints_.size());
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const LayoutJoint& joint = joints_[j];
    out[j] = 0.5 * (positions[joint.first] + positions[joint.second]);
    if (joint.offset != Vec3(0)) out[j] += turns[joint.first] * (scale * joint.offset);
  }
}

double BodyLayout::chain_height(std::span<const Vec3> rest_positions) const {
  double height = 0;
  for (const int end : {end_effectors_[0], end_effectors_[2]})
    for (int j = end; joints_[index(j)].parent != kNoJoint; j = joints_[index(j)].parent)
      height += glm::length(rest_positions[index(j)] - rest_positions[index(joints_[index(j)].parent)]);
  return height;
}

BodyLayoutKind layout_kind_of(const Skeleton& skeleton) {
  if (is_landmark_body(skeleton)) return BodyLayoutKind::Webcam38;
  return skeleton.has(HeadTop) && skeleton.has(LeftToeTip) && skeleton.has(RightToeTip)
             ? BodyLayoutKind::Split28
             : BodyLayoutKind::OldRig23;
}

RoleArray<Vec3> role_positions(const Skeleton& skeleton, std::span<const Vec3> joint_positions) {
  RoleArray<Vec3> found;
  RoleArray<bool> known;
  for (const HumanoidJoint role : kHumanoidJoints) {
    const int joint = skeleton.find(role);
    known[role] = joint != kNoJoint;
    if (known[role]) found[role] = joint_positions[index(joint)];
  }
  const auto fill = [&](HumanoidJoint role, HumanoidJoint from, HumanoidJoint to, double way) {
    if (!known[role] && known[from] && known[to]) {
      found[role] = found[from] + way * (found[to] - found[from]);
      known[role] = true;
    }
  };
  if (!known[Chest] && known[LeftShoulder] && known[RightShoulder]) {
    found[Chest] = 0.5 * (found[LeftShoulder] + found[RightShoulder]);
    known[Chest] = true;
  }
  fill(Pelvis, LeftHip, RightHip, 0.5);
  fill(Spine, Pelvis, Chest, 0.2);
  fill(SpineMiddle, Spine, Chest, 0.5);
  fill(Neck, Chest, Chest, 0);
  fill(LeftClavicle, Chest, LeftShoulder, 0.2);
  fill(RightClavicle, Chest, RightShoulder, 0.2);
  for (const HumanoidJoint role : kHumanoidJoints) {
    const auto parent = canonical_parent(role);
    if (!known[role] && parent) found[role] = found[*parent];
    known[role] = true;
  }
  return found;
}

}  // namespace posecoach
