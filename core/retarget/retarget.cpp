#include "core/retarget/retarget.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/assert.h"
#include "core/body/forward_kinematics.h"
#include "core/retarget/feet.h"
#include "core/retarget/grip.h"
#include "core/retarget/joint_mapping.h"
#include "core/retarget/root_path.h"
#include "core/retarget/turn_transfer.h"

namespace posecoach {
namespace {

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

struct Frames {
  std::vector<Vec3> roots;
  std::vector<Quat> global;  // frame-major
};

// The hips' path needs the pose first: the root hangs where the hips' place demands it.
Frames turned_frames(const Motion& coach, const Skeleton& body, const RetargetOptions& options,
                     const JointMapping& mapping) {
  TurnTransfer transfer(coach, body, mapping, options.rotations);
  const double scale =
      hip_height(body, transfer.body_t_pose()) / hip_height(coach.skeleton(), transfer.source_t_pose());
  const std::size_t joints = index(body.size());
  Frames frames{{}, std::vector<Quat>(index(coach.frame_count()) * joints)};
  std::vector<Vec3> positions(joints);
  for (int frame = 0; frame < coach.frame_count(); ++frame) {
    const auto global = std::span(frames.global).subspan(index(frame) * joints, joints);
    transfer.rotate(frame, global);
    if (options.method == RetargetMethod::Direction) transfer.point(frame, global);
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

// Joints that the coach lacks are carried by the turned body.
Motion scaled_motion(const Motion& coach, const Motion& turned, const JointMapping& mapping) {
  const Skeleton& body = turned.skeleton();
  const double coach_height = coach.skeleton().rest_height();
  const double scale = coach_height > 0 ? body.rest_height() / coach_height : 1.0;
  std::vector<Vec3> positions;
  positions.reserve(index(coach.frame_count()) * index(body.size()));
  for (int frame = 0; frame < coach.frame_count(); ++frame) {
    const std::size_t first = positions.size();
    for (int j = 0; j < body.size(); ++j) {
      const int source = mapping.joints[index(j)].source;
      const int parent = body.joint(j).parent;
      if (source != kNoJoint)
        positions.push_back(scale * coach.position(frame, source));
      else if (parent == kNoJoint)
        positions.push_back(turned.position(frame, j));
      else
        positions.push_back(positions[first + index(parent)] + turned.position(frame, j) -
                            turned.position(frame, parent));
    }
  }
  Result<Motion> made =
      Motion::from_positions(body, {coach.times().begin(), coach.times().end()}, std::move(positions));
  POSECOACH_ASSERT(made.has_value());
  return *std::move(made);
}

constexpr std::array<std::pair<RetargetMethod, std::string_view>, 3> kMethodNames = {
    {{RetargetMethod::Rotation, "rotation"},
     {RetargetMethod::Direction, "direction"},
     {RetargetMethod::Scale, "scale"}}};

}  // namespace

double bone_length_error(const Motion& motion) {
  const Skeleton& skeleton = motion.skeleton();
  double worst = 0;
  for (int frame = 0; frame < motion.frame_count(); ++frame)
    for (int j = 1; j < skeleton.size(); ++j) {
      const double wanted = skeleton.bone_length(j);
      if (wanted < 1e-6) continue;
      const double is =
          glm::distance(motion.position(frame, j), motion.position(frame, skeleton.joint(j).parent));
      worst = std::max(worst, std::abs(is - wanted) / wanted);
    }
  return worst;
}

std::string_view to_string(RetargetMethod method) {
  for (const auto& [known, name] : kMethodNames)
    if (known == method) return name;
  return "";
}

Result<RetargetMethod> retarget_method_from_string(std::string_view name) {
  for (const auto& [method, known] : kMethodNames)
    if (known == name) return method;
  return fail(ErrorCode::InvalidArgument,
              "there is no method " + std::string(name) + "; choose rotation, direction or scale");
}

Result<RetargetResult> retarget(const Motion& coach, const Skeleton& body, const RetargetOptions& options) {
  Result<JointMapping> mapping = map_joints(coach.skeleton(), body);
  if (!mapping) return tl::unexpected(mapping.error());
  Motion motion = assemble(coach, body, turned_frames(coach, body, options, *mapping));
  if (options.method == RetargetMethod::Scale) motion = scaled_motion(coach, motion, *mapping);
  RetargetResult result{std::move(motion), 0, {}};
  if (options.contacts == Contacts::On) {
    PosedMotion posed(result.motion);
    plant_feet(coach, posed);
    close_grip(coach, posed, result.contacts);
    result.motion = posed.motion();
  }
  result.bone_length_error_max = bone_length_error(result.motion);
  return result;
}

}  // namespace posecoach
