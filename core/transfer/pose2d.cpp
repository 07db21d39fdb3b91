#include "core/transfer/pose2d.h"

#include <algorithm>

namespace posecoach {
namespace {

constexpr std::array<std::string_view, kJoint2dCount> kNames = {
    "nose",        "neck",       "left_shoulder", "right_shoulder", "left_elbow",
    "right_elbow", "left_wrist", "right_wrist",   "mid_hip",        "left_hip",
    "right_hip",   "left_knee",  "right_knee",    "left_ankle",     "right_ankle"};

void set_midpoint(Pose2d& pose, Joint2d middle, Joint2d left, Joint2d right) {
  const bool known = pose.is_seen(left) && pose.is_seen(right);
  pose.seen[index(middle)] = known;
  if (known) pose[middle] = 0.5 * (pose[left] + pose[right]);
}

}  // namespace

std::string_view to_string(Joint2d joint) {
  return kNames[index(joint)];
}

Joint2d mirrored(Joint2d joint) {
  const std::size_t i = index(joint);
  if (joint == Joint2d::Nose || joint == Joint2d::Neck || joint == Joint2d::MidHip) return joint;
  // Left joints stand at even places before the mid-hip and at odd ones after it.
  const bool left = i < index(Joint2d::MidHip) ? i % 2 == 0 : i % 2 == 1;
  return static_cast<Joint2d>(left ? i + 1 : i - 1);
}

bool Pose2d::is_complete() const {
  return std::all_of(seen.begin(), seen.end(), [](bool s) { return s; });
}

Box2d bounding_box(const Pose2d& pose) {
  Box2d box;
  bool first = true;
  for (std::size_t i = 0; i < kJoint2dCount; ++i) {
    if (!pose.seen[i]) continue;
    const Vec2& p = pose.positions[i];
    box.low = first ? p : glm::min(box.low, p);
    box.high = first ? p : glm::max(box.high, p);
    first = false;
  }
  return box;
}

Pose2d translated(const Pose2d& pose, const Vec2& by) {
  Pose2d moved = pose;
  for (Vec2& p : moved.positions) p += by;
  return moved;
}

Pose2d centred(const Pose2d& pose) {
  return translated(pose, -bounding_box(pose).centre());
}

Pose2d scaled(const Pose2d& pose, double factor) {
  Pose2d result = pose;
  for (Vec2& p : result.positions) p *= factor;
  return result;
}

Pose2d mirrored(const Pose2d& pose) {
  Pose2d result;
  for (std::size_t i = 0; i < kJoint2dCount; ++i) {
    const std::size_t from = index(mirrored(static_cast<Joint2d>(i)));
    result.positions[i] = {-pose.positions[from].x, pose.positions[from].y};
    result.seen[i] = pose.seen[from];
  }
  return result;
}

Pose2d with_midpoints(Pose2d pose) {
  set_midpoint(pose, Joint2d::Neck, Joint2d::LeftShoulder, Joint2d::RightShoulder);
  set_midpoint(pose, Joint2d::MidHip, Joint2d::LeftHip, Joint2d::RightHip);
  return pose;
}

Pose2d bridged(Pose2d pose) {
  for (std::size_t upper = 0; upper < kBone2dCount; ++upper)
    for (std::size_t lower = upper + 1; lower < kBone2dCount; ++lower) {
      const Joint2d middle = kBones2d[upper].child;
      const bool is_limb = middle == Joint2d::LeftElbow || middle == Joint2d::RightElbow ||
                           middle == Joint2d::LeftKnee || middle == Joint2d::RightKnee;
      if (!is_limb || kBones2d[lower].parent != middle || pose.is_seen(middle)) continue;
      const Joint2d root = kBones2d[upper].parent, end = kBones2d[lower].child;
      if (!pose.is_seen(root) || !pose.is_seen(end)) continue;
      const double part =
          kAverageBoneLengths[upper] / (kAverageBoneLengths[upper] + kAverageBoneLengths[lower]);
      pose[middle] = glm::mix(pose[root], pose[end], part);
      pose.seen[index(middle)] = true;
    }
  return pose;
}

std::optional<Vec2> bone_vector(const Pose2d& pose, std::size_t bone) {
  const Bone2d& b = kBones2d[bone];
  if (!pose.is_seen(b.parent) || !pose.is_seen(b.child)) return std::nullopt;
  return pose[b.child] - pose[b.parent];
}

Pose2d pose_from_bones(std::span<const Vec2, kBone2dCount> bones, const Vec2& root) {
  Pose2d pose;
  pose.seen.fill(true);
  pose[Joint2d::MidHip] = root;
  for (std::size_t b = 0; b < kBone2dCount; ++b)
    pose[kBones2d[b].child] = pose[kBones2d[b].parent] + bones[b];
  return pose;
}

}  // namespace posecoach
