// A person in one picture, as 15 joints: what 2D pose transfer (Zheng et al., 2021) works on.
// Positions are in any unit, +Y down, as in a picture. Neck and mid-hip are always the mid-points of the
// shoulders and of the hips, whatever the source says: so every source means the same points.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "core/base/math.h"

namespace posecoach {

enum class Joint2d : unsigned char {
  Nose,
  Neck,
  LeftShoulder,
  RightShoulder,
  LeftElbow,
  RightElbow,
  LeftWrist,
  RightWrist,
  MidHip,
  LeftHip,
  RightHip,
  LeftKnee,
  RightKnee,
  LeftAnkle,
  RightAnkle,
};
inline constexpr std::size_t kJoint2dCount = 15;
inline constexpr std::size_t kBone2dCount = 14;

constexpr std::size_t index(Joint2d joint) {
  return static_cast<std::size_t>(joint);
}
// "nose", "neck", "left_shoulder", ...
std::string_view to_string(Joint2d joint);
Joint2d mirrored(Joint2d joint);

// A bone hangs at `parent` and ends at `child`; parents come before children, the root is MidHip.
struct Bone2d {
  Joint2d parent;
  Joint2d child;
  std::size_t twin;  // the same bone of the other side, or itself
};
inline constexpr std::array<Bone2d, kBone2dCount> kBones2d = {{
    {Joint2d::MidHip, Joint2d::Neck, 0},
    {Joint2d::Neck, Joint2d::Nose, 1},
    {Joint2d::Neck, Joint2d::LeftShoulder, 3},
    {Joint2d::Neck, Joint2d::RightShoulder, 2},
    {Joint2d::LeftShoulder, Joint2d::LeftElbow, 5},
    {Joint2d::RightShoulder, Joint2d::RightElbow, 4},
    {Joint2d::LeftElbow, Joint2d::LeftWrist, 7},
    {Joint2d::RightElbow, Joint2d::RightWrist, 6},
    {Joint2d::MidHip, Joint2d::LeftHip, 9},
    {Joint2d::MidHip, Joint2d::RightHip, 8},
    {Joint2d::LeftHip, Joint2d::LeftKnee, 11},
    {Joint2d::RightHip, Joint2d::RightKnee, 10},
    {Joint2d::LeftKnee, Joint2d::LeftAnkle, 13},
    {Joint2d::RightKnee, Joint2d::RightAnkle, 12},
}};

// Bone lengths of an average person as fractions of stature: what is assumed where nothing was seen.
// Drillis & Contini (1966), as in core/body/standard_body; the nose from the neck is ours.
inline constexpr std::array<double, kBone2dCount> kAverageBoneLengths = {
    0.288, 0.13, 0.109, 0.109, 0.172, 0.172, 0.157, 0.157, 0.052, 0.052, 0.245, 0.245, 0.246, 0.246};

struct Pose2d {
  std::array<Vec2, kJoint2dCount> positions;
  std::array<bool, kJoint2dCount> seen{};

  const Vec2& operator[](Joint2d joint) const { return positions[index(joint)]; }
  Vec2& operator[](Joint2d joint) { return positions[index(joint)]; }
  bool is_seen(Joint2d joint) const { return seen[index(joint)]; }
  bool is_complete() const;
};

// Only of seen joints; both zero when there are none.
struct Box2d {
  Vec2 low;
  Vec2 high;
  Vec2 centre() const { return 0.5 * (low + high); }
  Vec2 size() const { return high - low; }
};
Box2d bounding_box(const Pose2d& pose);

// Moved so that the box's centre is the origin, as the paper aligns poses.
Pose2d centred(const Pose2d& pose);
Pose2d scaled(const Pose2d& pose, double factor);
Pose2d translated(const Pose2d& pose, const Vec2& by);
// x -> -x with left and right exchanged: the person seen in a mirror.
Pose2d mirrored(const Pose2d& pose);
// Neck and mid-hip set to the mid-points where both sides are seen, and unseen where not.
Pose2d with_midpoints(Pose2d pose);

// An elbow or knee that was not seen between two seen ends is put between them, on a straight limb, and
// counts as seen: so the hand or foot keeps its place.
Pose2d bridged(Pose2d pose);

// From parent to child; nothing where an end was not seen.
std::optional<Vec2> bone_vector(const Pose2d& pose, std::size_t bone);
// Joints from bones, the mid-hip at `root`.
Pose2d pose_from_bones(std::span<const Vec2, kBone2dCount> bones, const Vec2& root);

}  // namespace posecoach
