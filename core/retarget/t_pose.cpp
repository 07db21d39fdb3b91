#include "core/retarget/t_pose.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/base/index.h"
#include "core/body/two_bone_ik.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

// Upper limbs and legs are posed by whoever made the rig: 15 degrees is beyond what differs between T-poses
// of one convention. The other bones are anatomy: only a rest pose that is no standing body at all is
// corrected.
struct CanonicalBone {
  HumanoidJoint from, to;
  Vec3 direction;
  double tolerance_degrees;
};
constexpr double kPosed = 15, kAnatomy = 50;
const CanonicalBone kBones[] = {
    {Spine, Chest, {0, 1, 0}, kAnatomy},
    {Neck, Head, {0, 1, 0}, kAnatomy},
    {Head, HeadTop, {0, 1, 0}, kAnatomy},
    {LeftClavicle, LeftShoulder, {1, 0, 0}, kAnatomy},
    {RightClavicle, RightShoulder, {-1, 0, 0}, kAnatomy},
    {LeftShoulder, LeftElbow, {1, 0, 0}, kPosed},
    {RightShoulder, RightElbow, {-1, 0, 0}, kPosed},
    {LeftElbow, LeftWrist, {1, 0, 0}, kPosed},
    {RightElbow, RightWrist, {-1, 0, 0}, kPosed},
    {LeftHip, LeftKnee, {0, -1, 0}, kPosed},
    {RightHip, RightKnee, {0, -1, 0}, kPosed},
    {LeftKnee, LeftAnkle, {0, -1, 0}, kPosed},
    {RightKnee, RightAnkle, {0, -1, 0}, kPosed},
    {LeftAnkle, LeftToe, {0, -0.45, 0.89}, kAnatomy},
    {RightAnkle, RightToe, {0, -0.45, 0.89}, kAnatomy},
};

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// Turns a rest pose that faces another way or lies down; identity when it stands and faces +Z more or less.
Quat upright_rotation(const Skeleton& skeleton) {
  const auto rest = skeleton.rest_positions();
  const int left = skeleton.find(LeftHip), right = skeleton.find(RightHip);
  int top = kNoJoint;
  for (const HumanoidJoint role : {Neck, Head, Chest})
    if (top == kNoJoint) top = skeleton.find(role);
  if (left == kNoJoint || right == kNoJoint || top == kNoJoint) return Quat(1, 0, 0, 0);
  const Vec3 across = rest[index(left)] - rest[index(right)];
  Vec3 up = rest[index(top)] - 0.5 * (rest[index(left)] + rest[index(right)]);
  if (glm::length(across) < 1e-9 || glm::length(up) < 1e-9) return Quat(1, 0, 0, 0);
  const Vec3 x = glm::normalize(across);
  up -= x * glm::dot(x, up);
  if (glm::length(up) < 1e-6) return Quat(1, 0, 0, 0);
  const Vec3 y = glm::normalize(up);
  const Quat turn = glm::conjugate(glm::quat_cast(Mat3(x, y, glm::cross(x, y))));
  const double angle = 2 * std::acos(std::min(1.0, std::abs(turn.w)));
  return angle > radians_from_degrees(30) ? turn : Quat(1, 0, 0, 0);
}

void lay_out(const Skeleton& skeleton, TPose& pose) {
  for (int j = 0; j < skeleton.size(); ++j) {
    const int parent = skeleton.joint(j).parent;
    const Vec3& offset = skeleton.joint(j).offset;
    pose.offsets[index(j)] = parent == kNoJoint ? offset : pose.rotations[index(parent)] * offset;
    pose.positions[index(j)] =
        parent == kNoJoint ? offset : pose.positions[index(parent)] + pose.offsets[index(j)];
  }
}

void turn_from(const Skeleton& skeleton, TPose& pose, int joint, const Quat& turn) {
  for (int j = joint; j < skeleton.size(); ++j)
    if (is_ancestor(skeleton, joint, j)) pose.rotations[index(j)] = turn * pose.rotations[index(j)];
  lay_out(skeleton, pose);
}

// How far apart the legs stand is up to whoever posed the rig (files of one character differ in it), so each
// ankle is brought under its hip as seen from the front. How a leg slants seen from the side is its shape.
void close_legs(const Skeleton& skeleton, TPose& pose) {
  const int left = skeleton.find(LeftHip), right = skeleton.find(RightHip);
  if (left == kNoJoint || right == kNoJoint) return;
  Vec3 across = pose.positions[index(left)] - pose.positions[index(right)];
  across.y = 0;
  if (glm::length(across) < 1e-9) return;
  across = glm::normalize(across);
  for (const auto& [hip, role] : {std::pair(left, LeftAnkle), std::pair(right, RightAnkle)}) {
    const int ankle = skeleton.find(role);
    if (ankle == kNoJoint || !is_ancestor(skeleton, hip, ankle)) continue;
    const Vec3 leg = pose.positions[index(ankle)] - pose.positions[index(hip)];
    const double aside = glm::dot(leg, across);
    if (std::abs(aside) <= 1e-9 * glm::length(leg)) continue;
    turn_from(skeleton, pose, hip, swing_between(leg, leg - across * aside));
  }
}

}  // namespace

bool is_ancestor(const Skeleton& skeleton, int ancestor, int joint) {
  while (joint != kNoJoint && joint != ancestor) joint = skeleton.joint(joint).parent;
  return joint == ancestor;
}

int common_ancestor(const Skeleton& skeleton, int a, int b) {
  if (a == kNoJoint || b == kNoJoint) return kNoJoint;
  while (!is_ancestor(skeleton, a, b)) a = skeleton.joint(a).parent;
  return a;
}

int pelvis_joint(const Skeleton& skeleton) {
  return common_ancestor(skeleton, skeleton.find(LeftHip), skeleton.find(RightHip));
}

int chest_joint(const Skeleton& skeleton) {
  return common_ancestor(skeleton, skeleton.find(LeftShoulder), skeleton.find(RightShoulder));
}

TPose make_t_pose(const Skeleton& skeleton) {
  const std::size_t joints = index(skeleton.size());
  TPose pose{std::vector<Quat>(joints, upright_rotation(skeleton)), std::vector<Vec3>(joints),
             std::vector<Vec3>(joints)};
  lay_out(skeleton, pose);
  for (const CanonicalBone& bone : kBones) {
    const int from = skeleton.find(bone.from), to = skeleton.find(bone.to);
    if (from == kNoJoint || to == kNoJoint || !is_ancestor(skeleton, from, to)) continue;
    const Vec3 direction = pose.positions[index(to)] - pose.positions[index(from)];
    if (glm::length(direction) < 1e-9 ||
        angle_between(direction, bone.direction) <= radians_from_degrees(bone.tolerance_degrees))
      continue;
    turn_from(skeleton, pose, from, swing_between(direction, bone.direction));
  }
  close_legs(skeleton, pose);
  return pose;
}

}  // namespace posecoach
