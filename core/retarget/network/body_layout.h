// The three joint structures that the paper's network knows, each as a rule that places its joints on a body
// given by canonical joints: the 28 joints of split Mixamo rigs, the 23 of the old Mixamo rig, and the webcam
// body (33 landmarks on 5 derived joints). Six body segments are common to all; the features of a segment
// mean the same in each, so a motion may go in by one structure and come out by another.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/body/forward_kinematics.h"
#include "core/body/skeleton.h"

namespace posecoach {

enum class BodyLayoutKind : unsigned char { Split28, OldRig23, Webcam38 };
inline constexpr std::array kBodyLayoutKinds = {BodyLayoutKind::Split28, BodyLayoutKind::OldRig23,
                                                BodyLayoutKind::Webcam38};

enum class BodySegment : unsigned char { LeftLeg, RightLeg, Spine, Head, LeftArm, RightArm };
inline constexpr std::size_t kBodySegmentCount = 6;

// What every layout can be placed on: positions and turns (global, away from the T-pose) by canonical joint.
template <typename T>
struct RoleArray : std::array<T, kHumanoidJointCount> {
  T& operator[](HumanoidJoint role) {
    return std::array<T, kHumanoidJointCount>::operator[](static_cast<std::size_t>(role));
  }
  const T& operator[](HumanoidJoint role) const {
    return std::array<T, kHumanoidJointCount>::operator[](static_cast<std::size_t>(role));
  }
  using std::array<T, kHumanoidJointCount>::operator[];
};

struct LayoutJoint {
  std::string name;
  int parent = kNoJoint;
  // Stands in the middle of these two (the same one twice for most)...
  HumanoidJoint first = HumanoidJoint::Pelvis, second = HumanoidJoint::Pelvis;
  // ...and away from there by this offset in T-pose axes, in rest heights, turned with `first` (faces,
  // fingers and heels of the webcam body).
  Vec3 offset;
  std::vector<BodySegment> segments;  // none for the root
};

class BodyLayout {
 public:
  static const BodyLayout& of(BodyLayoutKind kind);

  BodyLayoutKind kind() const { return kind_; }
  int size() const { return static_cast<int>(joints_.size()); }
  std::span<const LayoutJoint> joints() const { return joints_; }
  // Left toes, right toes, head, left hand, right hand.
  std::span<const int, 5> end_effectors() const { return end_effectors_; }
  // Joints of a segment, in order.
  std::vector<int> joints_of(BodySegment segment) const;

  // Where the layout's joints are. `scale` is the body's rest height, the unit of the offsets.
  void place(const RoleArray<Vec3>& positions, const RoleArray<Quat>& turns, double scale,
             std::span<Vec3> out) const;

  // The paper's height: the chain of bones from the left toes up to the root and on to the head.
  double chain_height(std::span<const Vec3> rest_positions) const;

 private:
  explicit BodyLayout(BodyLayoutKind kind);

  BodyLayoutKind kind_;
  std::vector<LayoutJoint> joints_;
  std::array<int, 5> end_effectors_{};
};

// The layout that fits a skeleton's own joints best: the webcam body's own, the old rig where the skeleton
// has no tips of head and toes, the split rig elsewhere.
BodyLayoutKind layout_kind_of(const Skeleton& skeleton);

// Canonical positions of a skeleton from those of its joints; a role that it lacks is put between or onto its
// neighbours. Needs hips, shoulders and what lies below them.
RoleArray<Vec3> role_positions(const Skeleton& skeleton, std::span<const Vec3> joint_positions);

}  // namespace posecoach
