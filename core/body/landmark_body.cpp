#include "core/body/landmark_body.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/assert.h"
#include "core/base/index.h"

namespace posecoach {
namespace {

constexpr int kPelvis = 0, kSpine = 1, kChest = 2, kNeck = 3, kHead = 4;

int parent_of(Landmark landmark) {
  switch (landmark) {
    case Landmark::LeftShoulder:
    case Landmark::RightShoulder:
      return kChest;
    case Landmark::LeftElbow:
      return landmark_joint(Landmark::LeftShoulder);
    case Landmark::RightElbow:
      return landmark_joint(Landmark::RightShoulder);
    case Landmark::LeftWrist:
      return landmark_joint(Landmark::LeftElbow);
    case Landmark::RightWrist:
      return landmark_joint(Landmark::RightElbow);
    case Landmark::LeftPinky:
    case Landmark::LeftIndex:
    case Landmark::LeftThumb:
      return landmark_joint(Landmark::LeftWrist);
    case Landmark::RightPinky:
    case Landmark::RightIndex:
    case Landmark::RightThumb:
      return landmark_joint(Landmark::RightWrist);
    case Landmark::LeftHip:
    case Landmark::RightHip:
      return kPelvis;
    case Landmark::LeftKnee:
      return landmark_joint(Landmark::LeftHip);
    case Landmark::RightKnee:
      return landmark_joint(Landmark::RightHip);
    case Landmark::LeftAnkle:
      return landmark_joint(Landmark::LeftKnee);
    case Landmark::RightAnkle:
      return landmark_joint(Landmark::RightKnee);
    case Landmark::LeftHeel:
    case Landmark::LeftFootIndex:
      return landmark_joint(Landmark::LeftAnkle);
    case Landmark::RightHeel:
    case Landmark::RightFootIndex:
      return landmark_joint(Landmark::RightAnkle);
    default:
      return kHead;
  }
}

std::optional<HumanoidJoint> role_of(Landmark landmark) {
  switch (landmark) {
    case Landmark::LeftShoulder:
      return HumanoidJoint::LeftShoulder;
    case Landmark::RightShoulder:
      return HumanoidJoint::RightShoulder;
    case Landmark::LeftElbow:
      return HumanoidJoint::LeftElbow;
    case Landmark::RightElbow:
      return HumanoidJoint::RightElbow;
    case Landmark::LeftWrist:
      return HumanoidJoint::LeftWrist;
    case Landmark::RightWrist:
      return HumanoidJoint::RightWrist;
    case Landmark::LeftHip:
      return HumanoidJoint::LeftHip;
    case Landmark::RightHip:
      return HumanoidJoint::RightHip;
    case Landmark::LeftKnee:
      return HumanoidJoint::LeftKnee;
    case Landmark::RightKnee:
      return HumanoidJoint::RightKnee;
    case Landmark::LeftAnkle:
      return HumanoidJoint::LeftAnkle;
    case Landmark::RightAnkle:
      return HumanoidJoint::RightAnkle;
    case Landmark::LeftFootIndex:
      return HumanoidJoint::LeftToe;
    case Landmark::RightFootIndex:
      return HumanoidJoint::RightToe;
    default:
      return std::nullopt;
  }
}

std::array<LandmarkJoint, kLandmarkBodyJointCount> make_joints() {
  std::array<LandmarkJoint, kLandmarkBodyJointCount> joints;
  joints[kPelvis] = {"pelvis", kNoJoint, HumanoidJoint::Pelvis, kNoJoint};
  joints[kSpine] = {"spine", kPelvis, HumanoidJoint::Spine, kNoJoint};
  joints[kChest] = {"chest", kSpine, HumanoidJoint::Chest, kNoJoint};
  joints[kNeck] = {"neck", kChest, HumanoidJoint::Neck, kNoJoint};
  joints[kHead] = {"head", kNeck, HumanoidJoint::Head, kNoJoint};
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    const auto landmark = static_cast<Landmark>(i);
    const Landmark other = mirrored(landmark);
    joints[index(landmark_joint(landmark))] = {std::string(to_string(landmark)), parent_of(landmark),
                                               role_of(landmark),
                                               other == landmark ? kNoJoint : landmark_joint(other)};
  }
  return joints;
}

// Direction from the parent in T-pose for the left side and the middle; the right side is its mirror image.
// Face and hand: an average head and an open hand, palm down.
Vec3 t_pose_direction(Landmark landmark) {
  switch (landmark) {
    case Landmark::Nose:
      return {0, -0.12, 0.99};
    case Landmark::LeftEyeInner:
      return {0.17, 0.33, 0.93};
    case Landmark::LeftEye:
      return {0.32, 0.33, 0.89};
    case Landmark::LeftEyeOuter:
      return {0.46, 0.32, 0.83};
    case Landmark::MouthLeft:
      return {0.25, -0.50, 0.83};
    case Landmark::LeftPinky:
      return {0.94, 0, -0.34};
    case Landmark::LeftIndex:
      return {0.97, 0, 0.24};
    case Landmark::LeftThumb:
      return {0.70, -0.10, 0.70};
    case Landmark::LeftKnee:
    case Landmark::LeftAnkle:
      return {0, -1, 0};
    default:  // ear, shoulder, elbow, wrist, hip
      return {1, 0, 0};
  }
}

struct FootShape {
  Vec3 heel, toe;  // from the ankle
};

// Heel and toe flat on the floor below the ankle: the triangle that the three lengths make.
FootShape foot_shape(double heel, double toe) {
  // BlazePose gives no heel-toe bone of its own in this tree; an ankle stands at about a quarter of the
  // foot's length above the floor (Drillis & Contini: 0.039 and 0.152 of stature), but never above its heel.
  const double height = std::min({0.039 / 0.152 * (heel + toe), 0.9 * heel, 0.9 * toe});
  return {{0, -height, -std::sqrt(std::max(0.0, heel * heel - height * height))},
          {0, -height, std::sqrt(std::max(0.0, toe * toe - height * height))}};
}

}  // namespace

std::optional<Landmark> landmark_of_joint(int joint) {
  if (joint < kLandmarkBodyDerivedJoints || joint >= static_cast<int>(kLandmarkBodyJointCount))
    return std::nullopt;
  return static_cast<Landmark>(joint - kLandmarkBodyDerivedJoints);
}

std::span<const LandmarkJoint, kLandmarkBodyJointCount> landmark_body_joints() {
  static const std::array<LandmarkJoint, kLandmarkBodyJointCount> kJoints = make_joints();
  return kJoints;
}

std::array<Vec3, kLandmarkBodyJointCount> landmark_body_positions(
    std::span<const Vec3, kLandmarkCount> landmarks) {
  const auto middle = [&](Landmark a, Landmark b) {
    return 0.5 * (landmarks[static_cast<std::size_t>(a)] + landmarks[static_cast<std::size_t>(b)]);
  };
  std::array<Vec3, kLandmarkBodyJointCount> positions;
  positions[kPelvis] = positions[kSpine] = middle(Landmark::LeftHip, Landmark::RightHip);
  positions[kChest] = positions[kNeck] = middle(Landmark::LeftShoulder, Landmark::RightShoulder);
  positions[kHead] = middle(Landmark::LeftEar, Landmark::RightEar);
  std::copy(landmarks.begin(), landmarks.end(), positions.begin() + kLandmarkBodyDerivedJoints);
  return positions;
}

std::array<double, kLandmarkBodyJointCount> landmark_body_confidence(
    std::span<const double, kLandmarkCount> visibility) {
  const auto lower = [&](Landmark a, Landmark b) {
    return std::min(visibility[static_cast<std::size_t>(a)], visibility[static_cast<std::size_t>(b)]);
  };
  std::array<double, kLandmarkBodyJointCount> confidence;
  confidence[kPelvis] = confidence[kSpine] = lower(Landmark::LeftHip, Landmark::RightHip);
  confidence[kChest] = confidence[kNeck] = lower(Landmark::LeftShoulder, Landmark::RightShoulder);
  confidence[kHead] = lower(Landmark::LeftEar, Landmark::RightEar);
  std::copy(visibility.begin(), visibility.end(), confidence.begin() + kLandmarkBodyDerivedJoints);
  return confidence;
}

Skeleton make_landmark_body(const LandmarkBodyLengths& lengths) {
  for (const double length : lengths) POSECOACH_ASSERT(std::isfinite(length) && length >= 0);
  const auto length_of = [&](Landmark landmark) { return lengths[index(landmark_joint(landmark))]; };
  std::vector<Joint> joints;
  for (const LandmarkJoint& joint : landmark_body_joints())
    joints.push_back({joint.name, joint.parent, {}, joint.role});
  joints[kChest].offset = {0, lengths[kChest], 0};
  joints[kHead].offset = lengths[kHead] * glm::normalize(Vec3(0, 0.98, 0.20));
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    const auto landmark = static_cast<Landmark>(i);
    const Landmark left = std::min(landmark, mirrored(landmark));  // BlazePose lists left before right
    const double side = landmark == left ? 1.0 : -1.0;
    const Vec3 direction = glm::normalize(t_pose_direction(left));
    joints[index(landmark_joint(landmark))].offset =
        length_of(landmark) * Vec3(side * direction.x, direction.y, direction.z);
  }
  for (const auto& [heel, toe] : {std::pair(Landmark::LeftHeel, Landmark::LeftFootIndex),
                                  std::pair(Landmark::RightHeel, Landmark::RightFootIndex)}) {
    const FootShape foot = foot_shape(length_of(heel), length_of(toe));
    joints[index(landmark_joint(heel))].offset = foot.heel;
    joints[index(landmark_joint(toe))].offset = foot.toe;
  }
  double lowest = 0;
  const Result<Skeleton> at_origin = Skeleton::make(joints);
  POSECOACH_ASSERT(at_origin.has_value());
  for (const Vec3& rest : at_origin->rest_positions()) lowest = std::min(lowest, rest.y);
  joints[kPelvis].offset = {0, -lowest, 0};
  Result<Skeleton> made = Skeleton::make(std::move(joints));
  POSECOACH_ASSERT(made.has_value());
  return *std::move(made);
}

bool is_landmark_body(const Skeleton& skeleton) {
  const auto wanted = landmark_body_joints();
  return skeleton.joints().size() == wanted.size() &&
         std::equal(wanted.begin(), wanted.end(), skeleton.joints().begin(),
                    [](const LandmarkJoint& a, const Joint& b) {
                      return a.name == b.name && a.parent == b.parent && a.role == b.role;
                    });
}

}  // namespace posecoach
