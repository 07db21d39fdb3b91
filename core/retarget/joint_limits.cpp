#include "core/retarget/joint_limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/base/index.h"
#include "core/body/two_bone_ik.h"
#include "core/retarget/limb.h"
#include "core/retarget/smoothing.h"
#include "core/retarget/t_pose.h"

namespace posecoach {
namespace {

constexpr double kBackwards = radians_from_degrees(10), kBent = radians_from_degrees(155);
constexpr double kGive = radians_from_degrees(5);
// A bend beyond this is rather one whose hinge is spun otherwise than it seems.
constexpr double kUnlikelyFrom = radians_from_degrees(30), kUnlikelyTo = radians_from_degrees(80);
constexpr double kNoLength = 1e-9;

struct Hinge {
  Limb limb;
  Vec3 along, backwards;  // T-pose axes of the body joint: the upper bone, and where its hinge must not go
  Quat body_rest;         // the body joint's rotation in T-pose
  // Radians off `backwards`: up to the first a bend counts as one backwards, from the second on as usual.
  double sector_from = 0, sector_to = 0;
  bool is_arm = false;
};

std::array<Hinge, 4> hinges_of(const Skeleton& skeleton) {
  const TPose t_pose = make_t_pose(skeleton);
  const auto hinge = [&](const Limb& limb, bool is_arm) {
    const Vec3 bone = t_pose.positions[index(limb.middle)] - t_pose.positions[index(limb.root)];
    return Hinge{limb,
                 bone,
                 is_arm ? Vec3(0, 0, -1) : Vec3(0, 0, 1),
                 t_pose.rotations[index(limb.body)],
                 radians_from_degrees(is_arm ? 35 : 60),
                 radians_from_degrees(is_arm ? 70 : 90),
                 is_arm};
  };
  return {hinge(left_arm(skeleton), true), hinge(right_arm(skeleton), true), hinge(left_leg(skeleton), false),
          hinge(right_leg(skeleton), false)};
}

struct Bend {
  Vec3 upper, lower;  // unit
  double angle = 0;
  double backwards = 0;  // how far it counts as one, 0 to 1
};

// Of a limb whose body joint is turned by `body`, global.
Bend bend_of(const Hinge& hinge, const Quat& body, const Vec3& root, const Vec3& middle, const Vec3& end) {
  if (glm::distance(root, middle) < kNoLength || glm::distance(middle, end) < kNoLength) return {};
  Bend bend{glm::normalize(middle - root), glm::normalize(end - middle)};
  const Vec3 off = bend.lower - bend.upper * glm::dot(bend.lower, bend.upper);
  bend.angle = std::atan2(glm::length(off), glm::dot(bend.lower, bend.upper));
  if (bend.angle <= kBackwards || bend.angle >= kUnlikelyTo) return bend;
  const Quat turn = body * glm::conjugate(hinge.body_rest);
  const Vec3 way = swing_between(turn * hinge.along, bend.upper) * (turn * hinge.backwards);
  const Vec3 aside = way - bend.upper * glm::dot(way, bend.upper);
  const double apart = std::atan2(glm::length(glm::cross(off, aside)), glm::dot(off, aside));
  const double up = glm::dot(bend.upper, turn * Vec3(0, 1, 0));
  const double raised = hinge.is_arm ? smooth_step(0, 0.5, up) : smooth_step(-0.3, 0.2, up);
  bend.backwards = (1 - smooth_step(hinge.sector_from, hinge.sector_to, apart)) * (1 - raised) *
                   (1 - smooth_step(kUnlikelyFrom, kUnlikelyTo, bend.angle));
  return bend;
}

// The angle itself up to `limit`, never more than kGive beyond; the slope is continuous.
double softly_limited(double angle, double limit) {
  return angle <= limit ? angle : limit + kGive * (1 - std::exp(-(angle - limit) / kGive));
}

double kept_angle(const Bend& bend) {
  const double kept = softly_limited(bend.angle, kBent);
  return kept - bend.backwards * (kept - softly_limited(bend.angle, kBackwards));
}

double beyond(const Bend& bend) {
  return std::max({0.0, bend.angle - kBent - kGive, bend.backwards * (bend.angle - kBackwards - kGive)});
}

template <typename Pose>
Bend bend_in(const Pose& pose, int frame, const Hinge& hinge, const Quat& body) {
  return bend_of(hinge, body, pose.position(frame, hinge.limb.root), pose.position(frame, hinge.limb.middle),
                 pose.position(frame, hinge.limb.end));
}

}  // namespace

JointLimitReport keep_joint_limits(PosedMotion& student) {
  JointLimitReport report;
  const auto hinges = hinges_of(student.skeleton());
  for (int f = 0; f < student.frame_count(); ++f) {
    bool turned = false;
    for (const Hinge& hinge : hinges) {
      const Bend bend = bend_in(student, f, hinge, student.rotation(f, hinge.limb.body));
      const double kept = kept_angle(bend);
      if (kept >= bend.angle) continue;
      const Vec3 off = glm::normalize(bend.lower - bend.upper * glm::dot(bend.lower, bend.upper));
      const Vec3 lower = std::cos(kept) * bend.upper + std::sin(kept) * off;
      student.turn(f, hinge.limb.middle, swing_between(bend.lower, lower), hinge.limb.end);
      report.largest_turn_degrees =
          std::max(report.largest_turn_degrees, degrees_from_radians(bend.angle - kept));
      turned = true;
    }
    if (turned) ++report.turned_frames;
  }
  return report;
}

JointLimitExcess joint_limit_excess(const Motion& motion) {
  JointLimitExcess excess;
  const auto hinges = hinges_of(motion.skeleton());
  const PosedMotion posed(motion);
  int frames = 0;
  for (int f = 0; f < motion.frame_count(); ++f) {
    double worst = 0;
    for (const Hinge& hinge : hinges) {
      worst = std::max(worst, beyond(bend_in(motion, f, hinge, posed.rotation(f, hinge.limb.body))));
    }
    excess.largest_degrees = std::max(excess.largest_degrees, degrees_from_radians(worst));
    frames += worst > 1e-9;
  }
  excess.share = static_cast<double>(frames) / motion.frame_count();
  return excess;
}

}  // namespace posecoach
