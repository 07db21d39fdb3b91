#include "core/retarget/experiments.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "core/base/assert.h"
#include "core/base/index.h"
#include "core/body/forward_kinematics.h"
#include "core/body/standard_body.h"

namespace posecoach {
namespace {

struct NamedBody {
  const char* name;
  double arms, shoulders;
};
constexpr std::array kBodies = {NamedBody{"arms +20 %", 1.2, 1},
                                NamedBody{"arms -20 %", 0.8, 1},
                                NamedBody{"shoulders +20 %", 1, 1.2},
                                NamedBody{"shoulders -20 %", 1, 0.8},
                                NamedBody{"arms +20 %, shoulders -20 %", 1.2, 0.8},
                                NamedBody{"arms -20 %, shoulders +20 %", 0.8, 1.2}};

}  // namespace

Result<std::vector<GripRow>> grips_on_other_bodies(const std::vector<CharacterMotion>& golf,
                                                   const EvaluatedMethod& method) {
  std::vector<GripRow> rows;
  for (const CharacterMotion& coach : golf)
    for (const NamedBody& proportions : kBodies) {
      const Skeleton body =
          make_standard_body({.arms = proportions.arms, .shoulders = proportions.shoulders});
      RetargetOptions options = method.options;
      options.contacts = Contacts::Off;
      const auto open = retarget(coach.motion, body, options);
      options.contacts = Contacts::On;
      const auto closed = retarget(coach.motion, body, options);
      if (!open || !closed) return tl::unexpected((open ? closed : open).error());
      const PairErrors before = compare(open->motion, open->motion, coach.motion);
      const PairErrors after = compare(closed->motion, closed->motion, coach.motion);
      rows.push_back({coach.name, proportions.name, before.grip_cm.value_or(0),
                      100 * closed->contacts.grip_error_p95_m, 100 * closed->contacts.reach_deficit_max_m,
                      static_cast<int>(closed->contacts.unreachable_frames.size()),
                      closed->contacts.grip_frames, after.slide_cm_s, after.coach_slide_cm_s});
    }
  return rows;
}

Motion with_spun_bones(const Motion& motion, double angle) {
  POSECOACH_ASSERT(motion.has_rotations());
  const Skeleton& skeleton = motion.skeleton();
  std::vector<Quat> global(index(skeleton.size())), local(index(motion.frame_count()) * global.size());
  std::vector<Vec3> roots;
  for (int frame = 0; frame < motion.frame_count(); ++frame) {
    global_rotations(skeleton, motion.rotations(frame), global);
    for (int j = 1; j < skeleton.size(); ++j) {
      const auto children = skeleton.children(j);
      if (children.size() != 1) continue;
      const Vec3 bone = skeleton.joint(*children.begin()).offset;
      if (glm::length(bone) > 1e-9)
        global[index(j)] = global[index(j)] * glm::angleAxis(angle, glm::normalize(bone));
    }
    local_rotations(skeleton, global, std::span(local).subspan(index(frame) * global.size(), global.size()));
    roots.push_back(motion.position(frame, 0));
  }
  Result<Motion> made = Motion::from_rotations(skeleton, {motion.times().begin(), motion.times().end()},
                                               std::move(roots), std::move(local));
  POSECOACH_ASSERT(made.has_value());
  return *std::move(made);
}

Skeleton with_sloped_limbs(const Skeleton& body, double angle) {
  using enum HumanoidJoint;
  std::vector<Joint> joints(body.joints().begin(), body.joints().end());
  const auto slope = [&](HumanoidJoint role, const Vec3& axis) {
    if (const int j = body.find(role); j != kNoJoint)
      joints[index(j)].offset = glm::angleAxis(angle, axis) * joints[index(j)].offset;
  };
  for (const HumanoidJoint role : {LeftElbow, LeftWrist}) slope(role, {0, 0, -1});
  for (const HumanoidJoint role : {RightElbow, RightWrist}) slope(role, {0, 0, 1});
  for (const HumanoidJoint role : {LeftKnee, RightKnee}) slope(role, {-1, 0, 0});
  for (const HumanoidJoint role : {LeftAnkle, RightAnkle}) slope(role, {1, 0, 0});
  Result<Skeleton> made = Skeleton::make(std::move(joints));
  POSECOACH_ASSERT(made.has_value());
  return *std::move(made);
}

Result<std::vector<HistoryRow>> part_by_history(const Motion& coach, const Skeleton& body,
                                                const std::vector<EvaluatedMethod>& methods) {
  const Motion other = with_spun_bones(coach, kPi / 2);
  std::vector<HistoryRow> rows;
  for (const EvaluatedMethod& method : methods) {
    const auto one = retarget(coach, body, method.options), two = retarget(other, body, method.options);
    if (!one || !two) return tl::unexpected((one ? two : one).error());
    HistoryRow row{method.name, 0, 0};
    for (int f = 0; f < coach.frame_count(); ++f)
      for (int j = 0; j < body.size(); ++j) {
        const auto local = [&](const Motion& motion) {
          return motion.position(f, j) - motion.position(f, 0);
        };
        const double off = 100 * glm::distance(local(one->motion), local(two->motion));
        row.mean_cm += off / (coach.frame_count() * body.size());
        row.max_cm = std::max(row.max_cm, off);
      }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace posecoach
