#include "core/retarget/retarget.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/assert.h"
#include "core/base/index.h"
#include "core/retarget/carry.h"
#include "core/retarget/doubt.h"
#include "core/retarget/feet.h"
#include "core/retarget/grip.h"
#include "core/retarget/joint_limits.h"
#include "core/retarget/joint_mapping.h"
#include "core/retarget/learned.h"
#include "core/retarget/stride.h"

namespace posecoach {
namespace {

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

constexpr std::array<std::pair<RetargetMethod, std::string_view>, 5> kMethodNames = {
    {{RetargetMethod::Rotation, "rotation"},
     {RetargetMethod::Direction, "direction"},
     {RetargetMethod::Scale, "scale"},
     {RetargetMethod::Paper, "paper"},
     {RetargetMethod::Network, "network"}}};

// The stages before the poses change bodies: whatever the camera did to them is repaired first.
Result<Motion> prepared(const Motion& coach, const RetargetOptions& options) {
  if (options.method == RetargetMethod::Network) return corrected_motion(coach);
  if (options.smoothing == InputSmoothing::WhereDoubtful) return smoothed_where_doubtful(coach);
  return coach;
}

Result<Motion> carried(const Motion& given, const Motion& ready, const Skeleton& body,
                       const RetargetOptions& options) {
  if (options.method == RetargetMethod::Paper)
    return carried_by_paper_network(ready, body, options.paper_weights);
  const bool turned_by_us = ready.has_rotations() && !given.has_rotations();
  return carried_by_turns(ready, body, options.method,
                          turned_by_us ? RotationSource::FileFirst : options.rotations);
}

// The constraint layer; what it finds in order it leaves as it is, to the last bit.
void constrain(const Motion& coach, const std::vector<double>& doubt, const RetargetOptions& options,
               RetargetResult& result) {
  const bool contacts = options.contacts == Contacts::On;
  const Stride stride = options.stride.value_or(options.method == RetargetMethod::Network ? Stride::LikeCoach
                                                                                          : Stride::AsTurned);
  const bool strides = contacts || stride == Stride::LikeCoach;
  const bool limits =
      options.limits.value_or(contacts ? JointLimits::On : JointLimits::Off) == JointLimits::On;
  if (!strides && !limits) return;
  PosedMotion posed(result.motion);
  if (strides) stride_like(coach, posed);
  if (limits) result.limits = keep_joint_limits(posed);
  if (contacts) {
    plant_feet(coach, posed);
    close_grip(coach, doubt, posed, result.contacts);
  }
  if (strides || result.limits.turned_frames > 0) result.motion = posed.motion();
}

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
  return fail(ErrorCode::InvalidArgument, "there is no method " + std::string(name) +
                                              "; choose rotation, direction, scale, paper or network");
}

Result<RetargetResult> retarget(const Motion& coach, const Skeleton& body, const RetargetOptions& options) {
  Result<JointMapping> mapping = map_joints(coach.skeleton(), body);
  if (!mapping) return tl::unexpected(mapping.error());
  const Result<Motion> ready = prepared(coach, options);
  if (!ready) return tl::unexpected(ready.error());
  Result<Motion> motion = carried(coach, *ready, body, options);
  if (!motion) return tl::unexpected(motion.error());
  if (options.method == RetargetMethod::Scale) motion = scaled_motion(*ready, *motion, *mapping);
  RetargetResult result{*std::move(motion), 0, {}, {}};
  constrain(*ready, doubts(coach), options, result);
  result.bone_length_error_max = bone_length_error(result.motion);
  return result;
}

}  // namespace posecoach
