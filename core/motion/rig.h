// Which joint of a foreign rig is which point of the body. Joints are told by name (CMU, DAZ, Mixamo,
// MotionBuilder, Biovision, 3ds Max, Unreal, SMPL, Xsens, Kinect and the program's own names), and by where
// they hang in the tree where names mean different things in different rigs: "LeftShoulder" is the collar
// bone where there is a "LeftArm", and the shoulder itself where there is none.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/body/skeleton.h"

namespace posecoach {

enum class Side : unsigned char { Middle, Left, Right };

// A joint's name in pieces: "mixamorig:LeftUpLeg" is Left, "upleg"; "thigh_l" is Left, "thigh".
struct RigName {
  Side side = Side::Middle;
  std::string base;  // lower case, letters and digits only
};

// A prefix that (nearly) all names share is dropped ("Bip01 L Thigh", "Character1_LeftArm").
std::vector<RigName> parse_rig_names(std::span<const std::string_view> names);

// One role or none for each joint; roles that the joints already have are ignored. Never gives a role twice;
// limbs are in order along the tree. Offsets may be in any unit and with any axis up.
std::vector<std::optional<HumanoidJoint>> map_roles(std::span<const Joint> joints);

// The same from names alone, for points that hang on no tree: joints written as markers, landmarks.
std::vector<std::optional<HumanoidJoint>> map_roles_by_name(std::span<const std::string_view> names);

// Incomplete unless the skeleton has pelvis, chest or neck, and shoulder, elbow, wrist, hip, knee and ankle
// of both sides; the message lists what is missing and which joints there are.
Result<void> check_humanoid(const Skeleton& skeleton);

}  // namespace posecoach
