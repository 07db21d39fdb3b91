#include "core/retarget/grip.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/base/index.h"
#include "core/body/two_bone_ik.h"
#include "core/retarget/limb.h"
#include "core/retarget/smoothing.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

constexpr double kHeld_m = 0.20, kLoose_m = 0.30;
// A camera guesses the depth of each hand by a decimetre and more; on a club wrists are a hand's breadth
// apart.
constexpr double kHeldWhenGuessed_m = 0.35, kLooseWhenGuessed_m = 0.50, kMostWhenGuessed_m = 0.10;
constexpr double kLongEnough_s = 0.5;
constexpr double kFlank_s = 0.15;
constexpr double kYieldSmoothing_s = 0.04;
constexpr double kMostCollarTurn = radians_from_degrees(12);

// Zeroes the stretches in which the hands are not together for long; a shorter motion may be all grip.
void drop_short_meetings(std::vector<double>& weights, std::span<const MediaTime> times) {
  std::size_t begin = 0;
  while (begin < weights.size()) {
    if (weights[begin] <= 0) {
      ++begin;
      continue;
    }
    std::size_t end = begin, held_first = weights.size(), held_last = 0;
    for (; end < weights.size() && weights[end] > 0; ++end)
      if (weights[end] >= 1) {
        held_first = std::min(held_first, end);
        held_last = end;
      }
    const bool whole_motion = begin == 0 && end == weights.size();
    const double held_s = held_first < weights.size() ? to_seconds(times[held_last] - times[held_first]) : -1;
    if (held_s < (whole_motion ? 0 : kLongEnough_s))
      std::fill(weights.begin() + static_cast<std::ptrdiff_t>(begin),
                weights.begin() + static_cast<std::ptrdiff_t>(end), 0.0);
    begin = end;
  }
}

struct Arm {
  Limb limb;
  LimbReacher reacher;
  int collar = kNoJoint;
};

Arm arm_of(const PosedMotion& student, const Limb& limb, HumanoidJoint collar) {
  return {limb, LimbReacher(student, limb), student.skeleton().find(collar)};
}

struct Reach {
  double left_m = 0, right_m = 0;
};

Vec3 wrists_middle(const PosedMotion& student, int frame, const Arm& left, const Arm& right) {
  return 0.5 * (student.position(frame, left.limb.end) + student.position(frame, right.limb.end));
}

// Where the middle between the wrists may be nearest to `wanted`, so that both arms reach.
NearestInBoth grip_centre(const PosedMotion& student, int frame, const Arm& left, const Arm& right,
                          const Vec3& relation, const Vec3& wanted, const Reach& reach) {
  return nearest_in_both(wanted, student.position(frame, left.limb.root) - 0.5 * relation, reach.left_m,
                         student.position(frame, right.limb.root) + 0.5 * relation, reach.right_m);
}

double doubt_in(std::span<const double> doubt, int frame) {
  return doubt.empty() ? 0 : doubt[index(frame)];
}

std::vector<Vec3> held_relations(const Motion& coach, std::span<const double> doubt) {
  std::vector<Vec3> relations;
  for (int f = 0; f < coach.frame_count(); ++f) {
    const Vec3 seen = wrist_relation(coach.skeleton(), coach.positions(f));
    const double most = std::max(1.0, glm::length(seen) / kMostWhenGuessed_m);
    relations.push_back(glm::mix(seen, seen / most, doubt_in(doubt, f)));
  }
  return relations;
}

// How far the wrists' middle gives way in each frame so that no arm locks; smooth over time.
std::vector<Vec3> grip_shifts(const Motion& coach, const PosedMotion& student, const Arm& left,
                              const Arm& right, std::span<const double> weights,
                              std::span<const Vec3> relations) {
  const Limb coach_left = left_arm(coach.skeleton()), coach_right = right_arm(coach.skeleton());
  std::vector<Vec3> shifts(index(student.frame_count()), Vec3(0));
  for (int f = 0; f < student.frame_count(); ++f) {
    if (weights[index(f)] <= 0) continue;
    const auto comfortable = [&](const Arm& arm, const Limb& coach_arm) {
      return arm.reacher.reach() * std::clamp(stretch(coach, f, coach_arm), kComfortableReach, kFullReach);
    };
    const Vec3 wanted = wrists_middle(student, f, left, right);
    shifts[index(f)] = grip_centre(student, f, left, right, relations[index(f)], wanted,
                                   {comfortable(left, coach_left), comfortable(right, coach_right)})
                           .place -
                       wanted;
  }
  return smoothed_over_time(shifts, student.times(), kYieldSmoothing_s);
}

// Swings the collar bone so that the shoulder comes nearer to `target` by at most `by`.
void bring_shoulder(PosedMotion& student, int frame, const Arm& arm, const Vec3& target, double by) {
  if (arm.collar == kNoJoint || by <= 0) return;
  const Vec3 bone = student.position(frame, arm.limb.root) - student.position(frame, arm.collar);
  const Vec3 way = target - student.position(frame, arm.limb.root);
  const double length = glm::length(bone), distance = glm::length(way);
  if (length < 1e-6 || distance < 1e-6) return;
  const double step = std::min(by, length * std::tan(kMostCollarTurn));
  student.turn(frame, arm.collar, swing_between(bone, bone + way * (step / distance)));
}

}  // namespace

Vec3 wrist_relation(const Skeleton& skeleton, std::span<const Vec3> positions) {
  return positions[index(skeleton.find(LeftWrist))] - positions[index(skeleton.find(RightWrist))];
}

std::vector<double> grip_weights(const Motion& coach, std::span<const double> doubt) {
  std::vector<double> near;
  for (int f = 0; f < coach.frame_count(); ++f) {
    const double distance = glm::length(wrist_relation(coach.skeleton(), coach.positions(f)));
    const double held = glm::mix(kHeld_m, kHeldWhenGuessed_m, doubt_in(doubt, f)),
                 loose = glm::mix(kLoose_m, kLooseWhenGuessed_m, doubt_in(doubt, f));
    near.push_back(std::clamp((loose - distance) / (loose - held), 0.0, 1.0));
  }
  drop_short_meetings(near, coach.times());
  // Widened before it is smoothed, so that the flanks lie outside and the grip itself keeps its full weight.
  std::vector<double> wide(near.size()), smooth(near.size());
  for (std::size_t i = 0; i < near.size(); ++i) {
    const auto [first, last] = frames_within(coach.times(), i, kFlank_s);
    for (std::size_t j = first; j <= last; ++j) wide[i] = std::max(wide[i], near[j]);
  }
  for (std::size_t i = 0; i < near.size(); ++i) {
    const auto [first, last] = frames_within(coach.times(), i, kFlank_s);
    double sum = 0, weights = 0;
    for (std::size_t j = first; j <= last; ++j) {
      const double off =
          to_seconds(coach.time(static_cast<int>(j)) - coach.time(static_cast<int>(i))) / kFlank_s;
      const double weight = 1.0001 - off * off;
      sum += weight * wide[j];
      weights += weight;
    }
    smooth[i] = sum / weights;
  }
  return smooth;
}

void close_grip(const Motion& coach, std::span<const double> doubt, PosedMotion& student,
                ContactReport& report) {
  const std::vector<double> weights = grip_weights(coach, doubt);
  const std::vector<Vec3> relations = held_relations(coach, doubt);
  const Skeleton& body = student.skeleton();
  const Arm left = arm_of(student, left_arm(body), LeftClavicle);
  const Arm right = arm_of(student, right_arm(body), RightClavicle);
  const std::vector<Vec3> shifts = grip_shifts(coach, student, left, right, weights, relations);
  const Reach full{kFullReach * left.reacher.reach(), kFullReach * right.reacher.reach()};
  std::vector<double> errors;
  for (int f = 0; f < student.frame_count(); ++f) {
    const double weight = weights[index(f)];
    if (weight <= 0) continue;
    const Vec3& relation = relations[index(f)];
    const Vec3 wanted = wrists_middle(student, f, left, right) + shifts[index(f)];
    NearestInBoth centre = grip_centre(student, f, left, right, relation, wanted, full);
    if (centre.gap > 0) {
      bring_shoulder(student, f, left, centre.place + 0.5 * relation, 0.5 * centre.gap);
      bring_shoulder(student, f, right, centre.place - 0.5 * relation, 0.5 * centre.gap);
      centre = grip_centre(student, f, left, right, relation, wanted, full);
    }
    const Vec3 left_target =
        glm::mix(student.position(f, left.limb.end), centre.place + 0.5 * relation, weight);
    const Vec3 right_target =
        glm::mix(student.position(f, right.limb.end), centre.place - 0.5 * relation, weight);
    left.reacher.reach_for(student, f, left_target);
    right.reacher.reach_for(student, f, right_target);
    if (weight < 1 - 1e-9) continue;
    ++report.grip_frames;
    report.reach_deficit_max_m = std::max(report.reach_deficit_max_m, centre.gap);
    if (centre.gap > 1e-6)
      report.unreachable_frames.push_back(f);
    else
      errors.push_back(glm::distance(wrist_relation(body, student.positions(f)), relation));
  }
  if (!errors.empty()) {
    const auto at = errors.begin() + static_cast<std::ptrdiff_t>((errors.size() - 1) * 95 / 100);
    std::nth_element(errors.begin(), at, errors.end());
    report.grip_error_p95_m = *at;
  }
}

}  // namespace posecoach
