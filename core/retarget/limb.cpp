#include "core/retarget/limb.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/index.h"
#include "core/body/two_bone_ik.h"
#include "core/retarget/smoothing.h"
#include "core/retarget/t_pose.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

constexpr double kBendSmoothing_s = 0.12;

// The middle joint's way off the line from root to end.
Vec3 bend_of(const Vec3& root, const Vec3& middle, const Vec3& end) {
  const Vec3 line = end - root;
  const double length2 = glm::dot(line, line);
  const Vec3 to_middle = middle - root;
  return length2 < 1e-12 ? to_middle : to_middle - line * (glm::dot(to_middle, line) / length2);
}

bool inside(const Vec3& p, const Vec3& centre, double radius) {
  return glm::distance(p, centre) <= radius * (1 + 1e-12);
}

Vec3 onto(const Vec3& p, const Vec3& centre, double radius) {
  const double distance = glm::distance(p, centre);
  return distance <= radius ? p : centre + (p - centre) * (radius / distance);
}

}  // namespace

Limb left_arm(const Skeleton& s) {
  return {s.find(LeftShoulder), s.find(LeftElbow), s.find(LeftWrist), chest_joint(s), {0, -0.8, -0.6}};
}
Limb right_arm(const Skeleton& s) {
  return {s.find(RightShoulder), s.find(RightElbow), s.find(RightWrist), chest_joint(s), {0, -0.8, -0.6}};
}
Limb left_leg(const Skeleton& s) {
  return {s.find(LeftHip), s.find(LeftKnee), s.find(LeftAnkle), pelvis_joint(s), {0, 0, 1}};
}
Limb right_leg(const Skeleton& s) {
  return {s.find(RightHip), s.find(RightKnee), s.find(RightAnkle), pelvis_joint(s), {0, 0, 1}};
}

double stretch(const Motion& motion, int frame, const Limb& limb) {
  const Vec3 root = motion.position(frame, limb.root), middle = motion.position(frame, limb.middle),
             end = motion.position(frame, limb.end);
  const double full = glm::distance(root, middle) + glm::distance(middle, end);
  return full > 1e-9 ? glm::distance(root, end) / full : 0.0;
}

LimbReacher::LimbReacher(const PosedMotion& motion, const Limb& limb) : limb_(limb) {
  const TPose t_pose = make_t_pose(motion.skeleton());
  upper_ = glm::distance(motion.position(0, limb.root), motion.position(0, limb.middle));
  lower_ = glm::distance(motion.position(0, limb.middle), motion.position(0, limb.end));
  const Vec3 usual = glm::conjugate(t_pose.rotations[index(limb.body)]) * limb.usual_bend;
  for (int f = 0; f < motion.frame_count(); ++f) {
    const Vec3 bend =
        bend_of(motion.position(f, limb.root), motion.position(f, limb.middle), motion.position(f, limb.end));
    bends_.push_back(glm::conjugate(motion.rotation(f, limb.body)) * bend);
  }
  const std::vector<Vec3> steady = smoothed_over_time(bends_, motion.times(), kBendSmoothing_s);
  for (std::size_t f = 0; f < bends_.size(); ++f) {
    const double shown = smooth_step(0.01, 0.05, glm::length(bends_[f]) / (upper_ + lower_));
    bends_[f] = glm::mix(steady[f], bends_[f], shown) + 1e-3 * (1 - shown) * (upper_ + lower_) * usual;
  }
}

double LimbReacher::reach_for(PosedMotion& motion, int frame, const Vec3& target) const {
  const Vec3 root = motion.position(frame, limb_.root);
  const Vec3 middle = motion.position(frame, limb_.middle), end = motion.position(frame, limb_.end);
  if (glm::distance(end, target) < 1e-12) return 0;
  const double upper = glm::distance(root, middle), lower = glm::distance(middle, end);
  if (upper < 1e-9 || lower < 1e-9) return glm::distance(end, target);
  const Vec3 bend = motion.rotation(frame, limb_.body) * bends_[index(frame)];
  const Vec3 turned_bend = swing_between(end - root, target - root) * bend;
  const TwoBoneSolution solution = solve_two_bones(root, target, root + turned_bend, upper, lower);
  motion.turn(frame, limb_.root, swing_between(middle - root, solution.middle - root), limb_.middle);
  motion.turn(frame, limb_.middle, swing_between(end - middle, solution.end - solution.middle), limb_.end);
  return solution.deficit;
}

NearestInBoth nearest_in_both(const Vec3& wanted, const Vec3& centre_a, double radius_a, const Vec3& centre_b,
                              double radius_b) {
  if (const Vec3 in_a = onto(wanted, centre_a, radius_a); inside(in_a, centre_b, radius_b)) return {in_a, 0};
  if (const Vec3 in_b = onto(wanted, centre_b, radius_b); inside(in_b, centre_a, radius_a)) return {in_b, 0};
  const Vec3 between = centre_b - centre_a;
  const double distance = glm::length(between);
  if (distance < 1e-12) return {onto(wanted, centre_a, std::min(radius_a, radius_b)), 0};
  const Vec3 axis = between / distance;
  if (distance >= radius_a + radius_b)
    return {centre_a + between * (radius_a / (radius_a + radius_b)), distance - radius_a - radius_b};
  // On the circle in which the two spheres meet.
  const double along = (distance * distance + radius_a * radius_a - radius_b * radius_b) / (2 * distance);
  const double radius = std::sqrt(std::max(0.0, radius_a * radius_a - along * along));
  const Vec3 centre = centre_a + axis * along;
  Vec3 out = wanted - centre;
  out -= axis * glm::dot(axis, out);
  const double length = glm::length(out);
  return {length < 1e-12 ? centre : centre + out * (radius / length), 0};
}

}  // namespace posecoach
