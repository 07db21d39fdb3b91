#include "core/retarget/feet.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/retarget/limb.h"
#include "core/retarget/root_path.h"
#include "core/retarget/t_pose.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

// For legs of 0.85 m; hysteresis between coming to rest and leaving.
constexpr double kUsualLeg_m = 0.85;
constexpr double kLandSpeed_m_s = 0.15, kLeaveSpeed_m_s = 0.35;
constexpr double kLandHeight_m = 0.05, kLeaveHeight_m = 0.08;
constexpr double kShortest_s = 0.12;
constexpr double kSpeedWindow_s = 0.06;
// A foot's way back to where it would be without the floor.
constexpr double kRelease_s = 0.25;
constexpr double kComfortableReach = 0.9995;
constexpr double kHipSmoothing_s = 0.15;

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

int toe_of(const Skeleton& skeleton, HumanoidJoint toe, HumanoidJoint ankle) {
  return skeleton.has(toe) ? skeleton.find(toe) : skeleton.find(ankle);
}

// Of a joint in T-pose above the lowest joint of the feet.
double rest_clearance(const Skeleton& skeleton, const TPose& t_pose, int joint) {
  const double hips = hip_centre(skeleton, t_pose.positions).y;
  return t_pose.positions[index(joint)].y - (hips - hip_height(skeleton, t_pose));
}

// The floor below a standing coach: the low end of where the feet's soles are.
double floor_height(const Motion& motion, const TPose& t_pose) {
  const Skeleton& skeleton = motion.skeleton();
  std::vector<double> heights;
  for (int f = 0; f < motion.frame_count(); ++f) {
    double lowest = 1e300;
    for (const int joint : {toe_of(skeleton, LeftToe, LeftAnkle), toe_of(skeleton, RightToe, RightAnkle)})
      lowest = std::min(lowest, motion.position(f, joint).y - rest_clearance(skeleton, t_pose, joint));
    heights.push_back(lowest);
  }
  const auto low = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 5);
  std::nth_element(heights.begin(), low, heights.end());
  return *low;
}

double speed_at(const Motion& motion, int frame, int joint) {
  int before = frame, after = frame;
  while (before > 0 && to_seconds(motion.time(frame) - motion.time(before)) < kSpeedWindow_s) --before;
  while (after + 1 < motion.frame_count() &&
         to_seconds(motion.time(after) - motion.time(frame)) < kSpeedWindow_s)
    ++after;
  const double seconds = to_seconds(motion.time(after) - motion.time(before));
  return seconds > 0 ? glm::distance(motion.position(after, joint), motion.position(before, joint)) / seconds
                     : 0;
}

std::vector<PlantedFoot> contacts_of(const Motion& coach, const TPose& t_pose, double floor, int toe) {
  const double size = coach.skeleton().leg_length() / kUsualLeg_m;
  const double clearance = rest_clearance(coach.skeleton(), t_pose, toe);
  std::vector<PlantedFoot> contacts;
  bool planted = false;
  for (int f = 0; f < coach.frame_count(); ++f) {
    const double speed = speed_at(coach, f, toe) / size;
    const double height = (coach.position(f, toe).y - clearance - floor) / size;
    planted = planted ? speed < kLeaveSpeed_m_s && height < kLeaveHeight_m
                      : speed < kLandSpeed_m_s && height < kLandHeight_m;
    if (!planted) continue;
    if (contacts.empty() || contacts.back().end != f) contacts.push_back({f, f});
    contacts.back().end = f + 1;
  }
  const bool whole = contacts.size() == 1 && contacts[0].end - contacts[0].begin == coach.frame_count();
  std::erase_if(contacts, [&](const PlantedFoot& c) {
    return !whole && to_seconds(coach.time(c.end - 1) - coach.time(c.begin)) < kShortest_s;
  });
  return contacts;
}

// From 1 to 0 with no kink at either end.
double release(double part) {
  const double t = std::clamp(part, 0.0, 1.0);
  return 1 - t * t * t * (t * (6 * t - 15) + 10);
}

// How far the foot must be moved in each frame to stand in its contacts, easing in and out around them.
std::vector<Vec3> foot_shifts(const PosedMotion& student, int toe, const std::vector<PlantedFoot>& contacts,
                              double toe_height) {
  std::vector<Vec3> shifts(index(student.frame_count()), Vec3(0));
  if (contacts.empty()) return shifts;
  for (const PlantedFoot& contact : contacts) {
    Vec3 place(0);
    for (int f = contact.begin; f < contact.end; ++f) place += student.position(f, toe);
    place /= contact.end - contact.begin;
    place.y = toe_height;
    for (int f = contact.begin; f < contact.end; ++f) shifts[index(f)] = place - student.position(f, toe);
  }
  const auto seconds = [&](int from, int to) {
    return to_seconds(student.times()[index(to)] - student.times()[index(from)]);
  };
  for (int f = 0; f < contacts.front().begin; ++f)
    shifts[index(f)] =
        release(seconds(f, contacts.front().begin) / kRelease_s) * shifts[index(contacts.front().begin)];
  for (int f = contacts.back().end; f < student.frame_count(); ++f)
    shifts[index(f)] =
        release(seconds(contacts.back().end - 1, f) / kRelease_s) * shifts[index(contacts.back().end - 1)];
  for (std::size_t i = 0; i + 1 < contacts.size(); ++i) {
    const int from = contacts[i].end - 1, to = contacts[i + 1].begin;
    const double gap = seconds(from, to);
    for (int f = from + 1; f < to; ++f) {
      constexpr double length = kRelease_s;
      if (gap >= 2 * length)
        shifts[index(f)] = release(seconds(from, f) / length) * shifts[index(from)] +
                           release(seconds(f, to) / length) * shifts[index(to)];
      else
        shifts[index(f)] = glm::mix(shifts[index(to)], shifts[index(from)], release(seconds(from, f) / gap));
    }
  }
  return shifts;
}

struct Leg {
  Limb limb;
  LimbReacher reacher;
  std::vector<Vec3> shifts;
};

// The least shift of the hips with which both legs reach their ankles' places, smooth over time.
std::vector<Vec3> hip_shifts(const PosedMotion& student, const Leg& left, const Leg& right) {
  std::vector<Vec3> shifts;
  for (int f = 0; f < student.frame_count(); ++f) {
    const auto centre = [&](const Leg& leg) {
      return student.position(f, leg.limb.end) + leg.shifts[index(f)] - student.position(f, leg.limb.root);
    };
    shifts.push_back(nearest_in_both(Vec3(0), centre(left), kComfortableReach * left.reacher.reach(),
                                     centre(right), kComfortableReach * right.reacher.reach())
                         .place);
  }
  std::vector<Vec3> smooth(shifts.size());
  for (std::size_t i = 0; i < shifts.size(); ++i) {
    double weights = 0;
    for (std::size_t j = 0; j < shifts.size(); ++j) {
      const double off = to_seconds(student.times()[j] - student.times()[i]) / kHipSmoothing_s;
      if (std::abs(off) > 3) continue;
      const double weight = std::exp(-0.5 * off * off);
      smooth[i] += weight * shifts[j];
      weights += weight;
    }
    smooth[i] /= weights;
  }
  return smooth;
}

}  // namespace

FootContacts find_foot_contacts(const Motion& coach) {
  const TPose t_pose = make_t_pose(coach.skeleton());
  const double floor = floor_height(coach, t_pose);
  return {contacts_of(coach, t_pose, floor, toe_of(coach.skeleton(), LeftToe, LeftAnkle)),
          contacts_of(coach, t_pose, floor, toe_of(coach.skeleton(), RightToe, RightAnkle))};
}

// The coach's ankle from his hip, in leg lengths, is the student's: his feet then go the coach's ways, and
// standing ones stand already but for the width of the hips. Turns alone would not do it where thighs and
// shins are proportioned differently.
void step_like(const Motion& coach, const TPose& coach_t_pose, const Limb& coach_leg, PosedMotion& student,
               const TPose& body_t_pose, const Limb& leg) {
  const auto stretched = [](const TPose& t_pose, const Limb& limb) {
    return glm::distance(t_pose.positions[index(limb.root)], t_pose.positions[index(limb.end)]);
  };
  const double ratio = stretched(body_t_pose, leg) / stretched(coach_t_pose, coach_leg);
  const LimbReacher reacher(student, leg);
  for (int f = 0; f < student.frame_count(); ++f) {
    const Vec3 way = coach.position(f, coach_leg.end) - coach.position(f, coach_leg.root);
    reacher.reach_for(student, f, student.position(f, leg.root) + ratio * way);
  }
}

void plant_feet(const Motion& coach, PosedMotion& student) {
  const FootContacts contacts = find_foot_contacts(coach);
  if (contacts.left.empty() && contacts.right.empty()) return;
  const Skeleton& body = student.skeleton();
  const TPose coach_t_pose = make_t_pose(coach.skeleton()), body_t_pose = make_t_pose(body);
  const double floor = floor_height(coach, coach_t_pose) * hip_height(body, body_t_pose) /
                       hip_height(coach.skeleton(), coach_t_pose);
  step_like(coach, coach_t_pose, left_leg(coach.skeleton()), student, body_t_pose, left_leg(body));
  step_like(coach, coach_t_pose, right_leg(coach.skeleton()), student, body_t_pose, right_leg(body));
  const auto leg_of = [&](const Limb& limb, HumanoidJoint toe_role, HumanoidJoint ankle_role,
                          const std::vector<PlantedFoot>& planted) {
    const int toe = toe_of(body, toe_role, ankle_role);
    const double height = floor + rest_clearance(body, body_t_pose, toe);
    return Leg{limb, LimbReacher(student, limb), foot_shifts(student, toe, planted, height)};
  };
  const Leg left = leg_of(left_leg(body), LeftToe, LeftAnkle, contacts.left);
  const Leg right = leg_of(right_leg(body), RightToe, RightAnkle, contacts.right);
  const std::vector<Vec3> hips = hip_shifts(student, left, right);
  for (int f = 0; f < student.frame_count(); ++f) {
    const Vec3 left_ankle = student.position(f, left.limb.end) + left.shifts[index(f)];
    const Vec3 right_ankle = student.position(f, right.limb.end) + right.shifts[index(f)];
    student.shift(f, hips[index(f)]);
    left.reacher.reach_for(student, f, left_ankle);
    right.reacher.reach_for(student, f, right_ankle);
  }
}

}  // namespace posecoach
