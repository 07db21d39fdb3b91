#include "core/retarget/carry.h"

#include "core/base/assert.h"
#include "core/base/index.h"
#include "core/body/forward_kinematics.h"
#include "core/retarget/joint_mapping.h"
#include "core/retarget/root_path.h"
#include "core/retarget/turn_transfer.h"

namespace posecoach {
namespace {

struct Frames {
  std::vector<Vec3> roots;
  std::vector<Quat> global;  // frame-major
};

// The hips' path needs the pose first: the root hangs where the hips' place demands it.
Frames turned_frames(const Motion& coach, const Skeleton& body, RetargetMethod method,
                     RotationSource rotations, const JointMapping& mapping) {
  TurnTransfer transfer(coach, body, mapping, rotations);
  const double scale =
      hip_height(body, transfer.body_t_pose()) / hip_height(coach.skeleton(), transfer.source_t_pose());
  const std::size_t joints = index(body.size());
  Frames frames{{}, std::vector<Quat>(index(coach.frame_count()) * joints)};
  std::vector<Vec3> positions(joints);
  for (int frame = 0; frame < coach.frame_count(); ++frame) {
    const auto global = std::span(frames.global).subspan(index(frame) * joints, joints);
    transfer.rotate(frame, global);
    if (method == RetargetMethod::Direction) transfer.point(frame, global);
    joint_positions(body, Vec3(0), global, positions);
    const Vec3 hips = scale * hip_centre(coach.skeleton(), coach.positions(frame));
    frames.roots.push_back(hips - hip_centre(body, positions));
  }
  return frames;
}

Motion assemble(const Motion& coach, const Skeleton& body, Frames frames) {
  const std::size_t joints = index(body.size());
  std::vector<Quat> local(frames.global.size());
  for (std::size_t first = 0; first < local.size(); first += joints)
    local_rotations(body, std::span<const Quat>(frames.global).subspan(first, joints),
                    std::span(local).subspan(first, joints));
  Result<Motion> made = Motion::from_rotations(body, {coach.times().begin(), coach.times().end()},
                                               std::move(frames.roots), std::move(local));
  POSECOACH_ASSERT(made.has_value());
  return *std::move(made);
}

}  // namespace

Result<Motion> carried_by_turns(const Motion& coach, const Skeleton& body, RetargetMethod method,
                                RotationSource rotations) {
  Result<JointMapping> mapping = map_joints(coach.skeleton(), body);
  if (!mapping) return tl::unexpected(mapping.error());
  return assemble(coach, body, turned_frames(coach, body, method, rotations, *mapping));
}

}  // namespace posecoach
