// How far beside its place a joint is seen, from six sides: written by scripts/film-error-table from
// faultless films of simulated golfers.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "core/body/humanoid.h"

namespace posecoach {

inline constexpr std::size_t kSwingStages = 13, kPuttStages = 6;
inline constexpr std::size_t kOffsetJointCount = 16;

// The neck's are the chest's, too; both are the middle of the shoulders in a webcam body.
inline constexpr std::array<HumanoidJoint, kOffsetJointCount> kOffsetJoints = {
    HumanoidJoint::Neck,       HumanoidJoint::Head,       HumanoidJoint::LeftShoulder,
    HumanoidJoint::LeftElbow,  HumanoidJoint::LeftWrist,  HumanoidJoint::RightShoulder,
    HumanoidJoint::RightElbow, HumanoidJoint::RightWrist, HumanoidJoint::LeftHip,
    HumanoidJoint::LeftKnee,   HumanoidJoint::LeftAnkle,  HumanoidJoint::LeftToe,
    HumanoidJoint::RightHip,   HumanoidJoint::RightKnee,  HumanoidJoint::RightAnkle,
    HumanoidJoint::RightToe};

// Thousandths of a leg length to a right-hander's left, up and front, stage after stage.
template <std::size_t Stages>
using JointOffsets = std::array<short, 3 * Stages>;
template <std::size_t Stages>
struct CameraOffsets {
  double camera_deg = 0;  // where the camera stood, as UsualFilmError has it
  std::array<JointOffsets<Stages>, kOffsetJointCount> joints;
};

// By rising angle.
inline constexpr std::size_t kOffsetCameras = 6;
extern const std::array<CameraOffsets<kSwingStages>, kOffsetCameras> kSwingOffsets;
extern const std::array<CameraOffsets<kPuttStages>, kOffsetCameras> kPuttOffsets;

// What is left about every stage, and how large the offsets are, in thousandths of a leg length as the camera
// sees them.
template <std::size_t Stages>
struct PartOfFilmError {
  std::string_view part;
  std::array<double, Stages> left_face_on, left_down_the_line, size_face_on, size_down_the_line;
};
inline constexpr std::size_t kFilmErrorParts = 7;
extern const std::array<PartOfFilmError<kSwingStages>, kFilmErrorParts> kSwingFilmErrors;
extern const std::array<PartOfFilmError<kPuttStages>, kFilmErrorParts> kPuttFilmErrors;

}  // namespace posecoach
