#include "core/body/humanoid.h"

namespace posecoach {
namespace {

constexpr std::array<std::string_view, kHumanoidJointCount> kJointNames = {
    "pelvis",     "spine",          "spine_middle",   "chest",         "neck",
    "head",       "head_top",       "left_clavicle",  "left_shoulder", "left_elbow",
    "left_wrist", "right_clavicle", "right_shoulder", "right_elbow",   "right_wrist",
    "left_hip",   "left_knee",      "left_ankle",     "left_toe",      "left_toe_tip",
    "right_hip",  "right_knee",     "right_ankle",    "right_toe",     "right_toe_tip"};

using enum HumanoidJoint;
constexpr std::array<HumanoidJoint, kHumanoidJointCount> kParents = {
    Pelvis,       Pelvis,    Spine,  SpineMiddle,   Chest,         Neck,       Head,    Chest,   LeftClavicle,
    LeftShoulder, LeftElbow, Chest,  RightClavicle, RightShoulder, RightElbow, Pelvis,  LeftHip, LeftKnee,
    LeftAnkle,    LeftToe,   Pelvis, RightHip,      RightKnee,     RightAnkle, RightToe};

constexpr std::array<HumanoidJoint, kHumanoidJointCount> kMirrors = {
    Pelvis,        Spine,         SpineMiddle, Chest,      Neck,         Head,         HeadTop,
    RightClavicle, RightShoulder, RightElbow,  RightWrist, LeftClavicle, LeftShoulder, LeftElbow,
    LeftWrist,     RightHip,      RightKnee,   RightAnkle, RightToe,     RightToeTip,  LeftHip,
    LeftKnee,      LeftAnkle,     LeftToe,     LeftToeTip};

constexpr std::size_t index_of(HumanoidJoint joint) {
  return static_cast<std::size_t>(joint);
}

}  // namespace

std::string_view to_string(HumanoidJoint joint) {
  return kJointNames[index_of(joint)];
}

std::optional<HumanoidJoint> humanoid_joint_from_string(std::string_view name) {
  for (HumanoidJoint joint : kHumanoidJoints)
    if (kJointNames[index_of(joint)] == name) return joint;
  return std::nullopt;
}

std::optional<HumanoidJoint> canonical_parent(HumanoidJoint joint) {
  if (joint == Pelvis) return std::nullopt;
  return kParents[index_of(joint)];
}

HumanoidJoint mirrored(HumanoidJoint joint) {
  return kMirrors[index_of(joint)];
}

}  // namespace posecoach
