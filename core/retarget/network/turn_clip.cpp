#include "core/retarget/network/turn_clip.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "core/base/index.h"
#include "core/body/mirror.h"
#include "core/body/standard_body.h"
#include "core/retarget/root_path.h"
#include "core/retarget/rotation_recovery.h"
#include "core/retarget/t_pose.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

constexpr double kHeadingSigmaFrames = 5;
constexpr double kSlowPathSigmaFrames = 45;

void add_what_the_network_does_not_see(std::vector<TurnFrame>& frames) {
  std::vector<Vec3> across, path;
  for (const TurnFrame& frame : frames) {
    across.push_back(frame.turns[Pelvis] * Vec3(1, 0, 0) + frame.turns[Chest] * Vec3(1, 0, 0));
    path.push_back(frame.hips);
  }
  const auto headings = smooth_headings(across);
  const auto slow = slow_path(path);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    frames[i].heading = headings[i];
    frames[i].slow_path = slow[i];
  }
}

}  // namespace

std::vector<Vec3> smoothed(std::span<const Vec3> values, double sigma_frames) {
  const int reach = std::max(1, static_cast<int>(std::ceil(3 * sigma_frames)));
  std::vector<double> weights;
  for (int i = -reach; i <= reach; ++i)
    weights.push_back(std::exp(-0.5 * i * i / (sigma_frames * sigma_frames)));
  const int count = static_cast<int>(values.size());
  std::vector<Vec3> out(values.size());
  for (int i = 0; i < count; ++i) {
    Vec3 sum(0);
    double total = 0;
    for (int k = std::max(-reach, -i); k <= std::min(reach, count - 1 - i); ++k) {
      sum += weights[index(k + reach)] * values[index(i + k)];
      total += weights[index(k + reach)];
    }
    out[index(i)] = sum / total;
  }
  return out;
}

std::vector<double> smooth_headings(std::span<const Vec3> across) {
  std::vector<Vec3> facing;
  for (const Vec3& line : across) facing.push_back({-line.z, 0, line.x});  // left is +X when facing +Z
  facing = smoothed(facing, kHeadingSigmaFrames);
  std::vector<double> headings;
  for (const Vec3& direction : facing) {
    double angle = std::atan2(direction.x, direction.z);
    if (glm::length(direction) < 1e-9) angle = headings.empty() ? 0 : headings.back();
    if (!headings.empty()) angle = headings.back() + std::remainder(angle - headings.back(), 2 * kPi);
    headings.push_back(angle);
  }
  return headings;
}

std::vector<Vec3> slow_path(std::span<const Vec3> path) {
  std::vector<Vec3> slow = smoothed(path, kSlowPathSigmaFrames);
  for (Vec3& point : slow) point.y = 0;
  return slow;
}

Result<TurnClip> make_turn_clip(std::string name, const Motion& given) {
  std::string missing;
  for (const HumanoidJoint role : {LeftHip, RightHip, LeftKnee, RightKnee, LeftAnkle, RightAnkle,
                                   LeftShoulder, RightShoulder, LeftElbow, RightElbow, LeftWrist, RightWrist})
    if (!given.skeleton().has(role)) missing += (missing.empty() ? "" : ", ") + std::string(to_string(role));
  if (!missing.empty()) return fail(ErrorCode::Incomplete, name + ": the skeleton lacks " + missing);

  const Motion motion = with_rotations(resample(given, kNetworkFramesPerSecond));
  const Skeleton& skeleton = motion.skeleton();
  const TPose t_pose = make_t_pose(skeleton);
  const double leg = skeleton.leg_length();
  std::vector<Quat> global(index(skeleton.size()));
  TurnClip clip{std::move(name), {}};
  for (int frame = 0; frame < motion.frame_count(); ++frame) {
    global_rotations(skeleton, motion.rotations(frame), global);
    TurnFrame& made = clip.frames.emplace_back();
    for (const HumanoidJoint role : kHumanoidJoints) {
      const int joint = skeleton.find(role);
      const auto parent = canonical_parent(role);
      if (joint != kNoJoint)
        made.turns[role] = global[index(joint)] * glm::conjugate(t_pose.rotations[index(joint)]);
      else if (parent)
        made.turns[role] = made.turns[*parent];
      else
        made.turns[role] = global[0] * glm::conjugate(t_pose.rotations[0]);
    }
    made.hips = hip_centre(skeleton, motion.positions(frame)) / leg;
  }
  add_what_the_network_does_not_see(clip.frames);
  return clip;
}

TurnClip mirrored(const TurnClip& clip) {
  TurnClip made = clip;
  for (TurnFrame& frame : made.frames) {
    const RoleArray<Quat> turns = frame.turns;
    for (const HumanoidJoint role : kHumanoidJoints) frame.turns[role] = mirrored(turns[mirrored(role)]);
    frame.hips = mirrored(frame.hips);
    frame.slow_path = mirrored(frame.slow_path);
    frame.heading = -frame.heading;
  }
  return made;
}

TurnClip reversed(TurnClip clip) {
  std::reverse(clip.frames.begin(), clip.frames.end());
  return clip;
}

RoleBody make_role_body(const RoleArray<Vec3>& rest) {
  RoleBody body{rest, 0, 0};
  const auto bone = [&](HumanoidJoint a, HumanoidJoint b) { return glm::length(rest[a] - rest[b]); };
  body.leg_length = 0.5 * (bone(LeftHip, LeftKnee) + bone(LeftKnee, LeftAnkle) + bone(RightHip, RightKnee) +
                           bone(RightKnee, RightAnkle));
  double low = rest[0].y, high = rest[0].y;
  for (const Vec3& position : rest) {
    low = std::min(low, position.y);
    high = std::max(high, position.y);
  }
  body.rest_height = high - low;
  return body;
}

RoleArray<Vec3> posed(const RoleBody& body, const TurnFrame& frame) {
  RoleArray<Vec3> out;
  for (const HumanoidJoint role : kHumanoidJoints) {
    const auto parent = canonical_parent(role);
    if (parent) out[role] = out[*parent] + frame.turns[*parent] * (body.rest[role] - body.rest[*parent]);
  }
  const Vec3 shift = body.leg_length * frame.hips - 0.5 * (out[LeftHip] + out[RightHip]);
  for (Vec3& position : out) position += shift;
  return out;
}

RoleBody random_role_body(std::mt19937_64& random, const BodyVariety& variety) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const bool cartoon = uniform(0, 1) < variety.cartoon_share;
  const double range = cartoon ? 0.45 : variety.proportions;
  const auto factor = [&] { return uniform(1 - range, 1 + range); };
  BodyProportions proportions;
  proportions.height_m = uniform(1.3, 2.1);
  proportions.arms = factor();
  proportions.forearms = uniform(0.9, 1.12);
  proportions.shoulders = factor();
  proportions.torso = factor();
  proportions.hips = factor();
  proportions.thighs = factor();
  proportions.shins = proportions.thighs * uniform(0.9, 1.12);
  const Skeleton skeleton = make_standard_body(proportions);
  RoleArray<Vec3> offsets;
  const double head = cartoon ? uniform(0.8, 2.2) : uniform(0.85, 1.2), feet = factor();
  for (const HumanoidJoint role : kHumanoidJoints) {
    offsets[role] = skeleton.joint(skeleton.find(role)).offset;
    if (role != Pelvis) offsets[role] *= uniform(0.97, 1.03);
    if (role == HeadTop || role == Head) offsets[role] *= head;
    if (role == LeftToe || role == RightToe || role == LeftToeTip || role == RightToeTip)
      offsets[role] *= feet;
  }
  // Rest directions differ between rigs, alike on both sides: collar bones and feet most, limbs little.
  if (uniform(0, 1) < variety.rest_tilt_share) {
    const auto tilt = [&](HumanoidJoint role, double degrees) {
      const Vec3 axis(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
      const Quat turn(
          glm::angleAxis(radians_from_degrees(uniform(0, degrees)), glm::normalize(axis + Vec3(1e-3, 0, 0))));
      offsets[role] = turn * offsets[role];
      const HumanoidJoint twin = mirrored(role);
      if (twin != role)
        offsets[twin] = mirrored(offsets[role]);
      else
        offsets[role].x = 0;
    };
    for (const HumanoidJoint role : {LeftHip, LeftClavicle, LeftShoulder, LeftToe, Head}) tilt(role, 18);
    for (const HumanoidJoint role : {Spine, SpineMiddle, Chest, Neck, HeadTop}) tilt(role, 12);
    for (const HumanoidJoint role : {LeftKnee, LeftAnkle, LeftElbow, LeftWrist, LeftToeTip}) tilt(role, 6);
  }
  RoleArray<Vec3> rest;
  for (const HumanoidJoint role : kHumanoidJoints) {
    const auto parent = canonical_parent(role);
    rest[role] = offsets[role] + (parent ? rest[*parent] : Vec3(0));
  }
  double low = 0;
  for (const Vec3& position : rest) low = std::min(low, position.y);
  for (Vec3& position : rest) position.y -= low;
  return make_role_body(rest);
}

}  // namespace posecoach
