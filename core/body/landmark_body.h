// The webcam body: the 33 landmarks of the pose stage hung on five derived joints, so that a body seen by a
// camera is a Skeleton like any other. Derived: pelvis and spine (both at mid-hips), chest and neck (both at
// mid-shoulders), head (mid-ears). Two joints in one place let hips, torso line, shoulders and head turn
// independently, as the landmarks do; the bone between them has length 0.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "core/body/landmarks.h"
#include "core/body/skeleton.h"

namespace posecoach {

inline constexpr int kLandmarkBodyDerivedJoints = 5;
inline constexpr std::size_t kLandmarkBodyJointCount = kLandmarkCount + kLandmarkBodyDerivedJoints;
using LandmarkBodyLengths = std::array<double, kLandmarkBodyJointCount>;  // of the bone to the parent, metres

// Where a landmark stands among the body's joints; the order within the landmarks is BlazePose's.
constexpr int landmark_joint(Landmark landmark) {
  return static_cast<int>(landmark) + kLandmarkBodyDerivedJoints;
}
// The landmark that a joint is; nothing for derived joints.
std::optional<Landmark> landmark_of_joint(int joint);

struct LandmarkJoint {
  std::string name;
  int parent = kNoJoint;
  std::optional<HumanoidJoint> role;
  int twin = kNoJoint;  // the same joint of the other side
};
std::span<const LandmarkJoint, kLandmarkBodyJointCount> landmark_body_joints();

// From 33 landmark positions in any frame to the body's joints in the same frame.
std::array<Vec3, kLandmarkBodyJointCount> landmark_body_positions(
    std::span<const Vec3, kLandmarkCount> landmarks);
// The same for confidences: a derived joint has the lower one of its two landmarks.
std::array<double, kLandmarkBodyJointCount> landmark_body_confidence(
    std::span<const double, kLandmarkCount> visibility);

// The T-pose with these bone lengths (those of the derived zero-length bones and the root count as 0), the
// feet flat on the floor, the pelvis above the origin. Asserts finite lengths that are not negative.
Skeleton make_landmark_body(const LandmarkBodyLengths& lengths);

// True for skeletons made by make_landmark_body, of any lengths.
bool is_landmark_body(const Skeleton& skeleton);

}  // namespace posecoach
