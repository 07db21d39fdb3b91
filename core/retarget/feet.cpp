#include "core/retarget/feet.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/base/index.h"
#include "core/retarget/limb.h"
#include "core/retarget/root_path.h"
#include "core/retarget/smoothing.h"
#include "core/retarget/t_pose.h"

namespace posecoach {
namespace {

// A foot's way back to where it would be without the floor.
constexpr double kRelease_s = 0.25;
// A heel or toe that takes over a little high or low settles at its height.
constexpr double kSettling_s = 0.15;
constexpr double kHipSmoothing_s = 0.15;

// From 1 to 0 with no kink at either end.
double release(double part) {
  const double t = std::clamp(part, 0.0, 1.0);
  return 1 - t * t * t * (t * (6 * t - 15) + 10);
}

// Contacts [first, last] without a gap between them.
struct Stance {
  std::size_t first = 0, last = 0;
};

std::vector<Stance> stances_of(const std::vector<PlantedFoot>& contacts) {
  std::vector<Stance> stances;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (i == 0 || contacts[i].begin != contacts[i - 1].end) stances.push_back({i, i});
    stances.back().last = i;
  }
  return stances;
}

class FootPlanter {
 public:
  FootPlanter(const PosedMotion& student, const TPose& t_pose, bool left, double floor)
      : student_(student), t_pose_(t_pose), left_(left), floor_(floor) {}

  // How far the foot must be moved in each frame to stand in its contacts, easing in and out around them.
  std::vector<Vec3> shifts(const std::vector<PlantedFoot>& contacts) const {
    std::vector<Vec3> shifts(index(student_.frame_count()), Vec3(0));
    const std::vector<Stance> stances = stances_of(contacts);
    for (const Stance& stance : stances) stand(contacts, stance, shifts);
    for (std::size_t i = 0; i <= stances.size() && !stances.empty(); ++i)
      ease(i == 0 ? -1 : contacts[stances[i - 1].last].end - 1,
           i == stances.size() ? student_.frame_count() : contacts[stances[i].first].begin, shifts);
    return shifts;
  }

 private:
  // The first contact of a stance stands in the middle of where the foot would be; the next ones go on from
  // where they take over, all at the height of a foot on the floor where the heel is down.
  void stand(const std::vector<PlantedFoot>& contacts, const Stance& stance,
             std::vector<Vec3>& shifts) const {
    for (std::size_t i = stance.first; i <= stance.last; ++i) {
      const PlantedFoot& contact = contacts[i];
      const int joint = anchor_joint(student_.skeleton(), contact.anchor, left_);
      const double height = floor_ + sole_clearance(student_.skeleton(), t_pose_, joint);
      Vec3 place(0);
      double too_high = 0;
      if (i == stance.first) {
        for (int f = contact.begin; f < contact.end; ++f) place += student_.position(f, joint);
        place /= contact.end - contact.begin;
        place.y = height;
      } else {
        place = student_.position(contact.begin - 1, joint) + shifts[index(contact.begin - 1)];
        too_high = place.y - height;
      }
      for (int f = contact.begin; f < contact.end; ++f) {
        const double sunk = too_high * (1 - release(seconds(contact.begin, f) / kSettling_s));
        shifts[index(f)] = place - Vec3(0, sunk, 0) - student_.position(f, joint);
      }
    }
  }

  // Between the planted frames `from` and `to` (-1 and the frame count: none).
  void ease(int from, int to, std::vector<Vec3>& shifts) const {
    const bool has_from = from >= 0, has_to = to < student_.frame_count();
    const double gap = has_from && has_to ? seconds(from, to) : 1e9;
    for (int f = from + 1; f < to; ++f) {
      if (gap < 2 * kRelease_s) {
        shifts[index(f)] = glm::mix(shifts[index(to)], shifts[index(from)], release(seconds(from, f) / gap));
        continue;
      }
      Vec3 shift(0);
      if (has_from) shift += release(seconds(from, f) / kRelease_s) * shifts[index(from)];
      if (has_to) shift += release(seconds(f, to) / kRelease_s) * shifts[index(to)];
      shifts[index(f)] = shift;
    }
  }

  double seconds(int from, int to) const {
    return to_seconds(student_.times()[index(to)] - student_.times()[index(from)]);
  }

  const PosedMotion& student_;
  const TPose& t_pose_;
  bool left_;
  double floor_;
};

struct Leg {
  Limb limb;
  LimbReacher reacher;
  std::vector<Vec3> shifts;
};

// The least shift of the hips with which both legs reach their ankles' places, smooth over time.
std::vector<Vec3> hip_shifts(const Motion& coach, const PosedMotion& student, const Leg& left,
                             const Leg& right) {
  const Limb coach_left = left_leg(coach.skeleton()), coach_right = right_leg(coach.skeleton());
  std::vector<Vec3> shifts;
  for (int f = 0; f < student.frame_count(); ++f) {
    const auto centre = [&](const Leg& leg) {
      return student.position(f, leg.limb.end) + leg.shifts[index(f)] - student.position(f, leg.limb.root);
    };
    const auto reach = [&](const Leg& leg, const Limb& coach_leg) {
      return leg.reacher.reach() * std::clamp(stretch(coach, f, coach_leg), kComfortableReach, kFullReach);
    };
    shifts.push_back(nearest_in_both(Vec3(0), centre(left), reach(left, coach_left), centre(right),
                                     reach(right, coach_right))
                         .place);
  }
  return smoothed_over_time(shifts, student.times(), kHipSmoothing_s);
}

}  // namespace

void plant_feet(const Motion& coach, PosedMotion& student) {
  const FootContacts contacts = find_foot_contacts(coach);
  const Skeleton& body = student.skeleton();
  const TPose coach_t_pose = make_t_pose(coach.skeleton()), t_pose = make_t_pose(body);
  if (contacts.left.empty() && contacts.right.empty()) return;
  const double floor =
      contacts.floor_m * hip_height(body, t_pose) / hip_height(coach.skeleton(), coach_t_pose);
  const Leg left{left_leg(body), LimbReacher(student, left_leg(body)),
                 FootPlanter(student, t_pose, true, floor).shifts(contacts.left)};
  const Leg right{right_leg(body), LimbReacher(student, right_leg(body)),
                  FootPlanter(student, t_pose, false, floor).shifts(contacts.right)};
  const std::vector<Vec3> hips = hip_shifts(coach, student, left, right);
  for (int f = 0; f < student.frame_count(); ++f) {
    const Vec3 left_ankle = student.position(f, left.limb.end) + left.shifts[index(f)];
    const Vec3 right_ankle = student.position(f, right.limb.end) + right.shifts[index(f)];
    student.shift(f, hips[index(f)]);
    left.reacher.reach_for(student, f, left_ankle);
    right.reacher.reach_for(student, f, right_ankle);
  }
}

}  // namespace posecoach
