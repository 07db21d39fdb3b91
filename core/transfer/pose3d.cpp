#include "core/transfer/pose3d.h"

#include <string>

namespace posecoach {
namespace {

struct Source {
  Joint2d joint;
  HumanoidJoint role;
};
constexpr std::array<Source, 13> kSources = {{
    {Joint2d::Nose, HumanoidJoint::Head},
    {Joint2d::LeftShoulder, HumanoidJoint::LeftShoulder},
    {Joint2d::RightShoulder, HumanoidJoint::RightShoulder},
    {Joint2d::LeftElbow, HumanoidJoint::LeftElbow},
    {Joint2d::RightElbow, HumanoidJoint::RightElbow},
    {Joint2d::LeftWrist, HumanoidJoint::LeftWrist},
    {Joint2d::RightWrist, HumanoidJoint::RightWrist},
    {Joint2d::LeftHip, HumanoidJoint::LeftHip},
    {Joint2d::RightHip, HumanoidJoint::RightHip},
    {Joint2d::LeftKnee, HumanoidJoint::LeftKnee},
    {Joint2d::RightKnee, HumanoidJoint::RightKnee},
    {Joint2d::LeftAnkle, HumanoidJoint::LeftAnkle},
    {Joint2d::RightAnkle, HumanoidJoint::RightAnkle},
}};

}  // namespace

Result<std::vector<Pose3d>> poses_of(const Motion& motion) {
  std::string missing;
  for (const Source& source : kSources)
    if (!motion.skeleton().has(source.role))
      missing += (missing.empty() ? "" : ", ") + std::string(to_string(source.role));
  if (!missing.empty())
    return fail(ErrorCode::Incomplete, "the motion lacks joints that a 2D pose needs: " + missing);
  std::vector<Pose3d> poses(static_cast<std::size_t>(motion.frame_count()));
  for (int frame = 0; frame < motion.frame_count(); ++frame) {
    Pose3d& pose = poses[static_cast<std::size_t>(frame)];
    for (const Source& source : kSources)
      pose[source.joint] = motion.position(frame, motion.skeleton().find(source.role));
    pose[Joint2d::Neck] = 0.5 * (pose[Joint2d::LeftShoulder] + pose[Joint2d::RightShoulder]);
    pose[Joint2d::MidHip] = 0.5 * (pose[Joint2d::LeftHip] + pose[Joint2d::RightHip]);
  }
  return poses;
}

Pose2d project(const Pose3d& pose, const CameraTurn& view) {
  const double cos_yaw = std::cos(view.yaw), sin_yaw = std::sin(view.yaw);
  const double cos_pitch = std::cos(view.pitch), sin_pitch = std::sin(view.pitch);
  Pose2d result;
  result.seen.fill(true);
  for (std::size_t i = 0; i < kJoint2dCount; ++i) {
    const Vec3& p = pose.positions[i];
    const double towards_camera = cos_yaw * p.z - sin_yaw * p.x;
    result.positions[i] = {cos_yaw * p.x + sin_yaw * p.z, sin_pitch * towards_camera - cos_pitch * p.y};
  }
  return result;
}

Pose3d mirrored(const Pose3d& pose) {
  Pose3d result;
  for (std::size_t i = 0; i < kJoint2dCount; ++i) {
    const Vec3& p = pose.positions[index(mirrored(static_cast<Joint2d>(i)))];
    result.positions[i] = {-p.x, p.y, p.z};
  }
  return result;
}

std::array<double, kBone2dCount> bone_lengths(const Pose3d& pose) {
  std::array<double, kBone2dCount> lengths;
  for (std::size_t b = 0; b < kBone2dCount; ++b)
    lengths[b] = glm::length(pose[kBones2d[b].child] - pose[kBones2d[b].parent]);
  return lengths;
}

}  // namespace posecoach
