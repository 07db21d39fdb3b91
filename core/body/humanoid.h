// The canonical humanoid joint set onto which every rig maps by name. Named by the anatomical point that the
// joint stands for (a golfer's words), not by the bone that it turns: a BVH's "LeftForeArm" is the point
// LeftElbow.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace posecoach {

enum class HumanoidJoint : unsigned char {
  Pelvis,
  Spine,
  SpineMiddle,
  Chest,
  Neck,
  Head,
  HeadTop,
  LeftClavicle,
  LeftShoulder,
  LeftElbow,
  LeftWrist,
  RightClavicle,
  RightShoulder,
  RightElbow,
  RightWrist,
  LeftHip,
  LeftKnee,
  LeftAnkle,
  LeftToe,
  LeftToeTip,
  RightHip,
  RightKnee,
  RightAnkle,
  RightToe,
  RightToeTip,
};
inline constexpr std::size_t kHumanoidJointCount = 25;

inline constexpr std::array<HumanoidJoint, kHumanoidJointCount> kHumanoidJoints = {
    HumanoidJoint::Pelvis,        HumanoidJoint::Spine,        HumanoidJoint::SpineMiddle,
    HumanoidJoint::Chest,         HumanoidJoint::Neck,         HumanoidJoint::Head,
    HumanoidJoint::HeadTop,       HumanoidJoint::LeftClavicle, HumanoidJoint::LeftShoulder,
    HumanoidJoint::LeftElbow,     HumanoidJoint::LeftWrist,    HumanoidJoint::RightClavicle,
    HumanoidJoint::RightShoulder, HumanoidJoint::RightElbow,   HumanoidJoint::RightWrist,
    HumanoidJoint::LeftHip,       HumanoidJoint::LeftKnee,     HumanoidJoint::LeftAnkle,
    HumanoidJoint::LeftToe,       HumanoidJoint::LeftToeTip,   HumanoidJoint::RightHip,
    HumanoidJoint::RightKnee,     HumanoidJoint::RightAnkle,   HumanoidJoint::RightToe,
    HumanoidJoint::RightToeTip};

// "left_elbow", "pelvis", ... as written in files.
std::string_view to_string(HumanoidJoint joint);
std::optional<HumanoidJoint> humanoid_joint_from_string(std::string_view name);

// The nearest canonical ancestor; Pelvis has none.
std::optional<HumanoidJoint> canonical_parent(HumanoidJoint joint);

// Left for right and the other way round; middle joints are their own mirror.
HumanoidJoint mirrored(HumanoidJoint joint);

}  // namespace posecoach
