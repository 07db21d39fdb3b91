#include "core/body/two_bone_ik.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace posecoach {
namespace {

Vec3 any_perpendicular(const Vec3& direction) {
  const Vec3 axis = std::abs(direction.x) < 0.9 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  return glm::normalize(glm::cross(direction, axis));
}

}  // namespace

TwoBoneSolution solve_two_bones(const Vec3& root, const Vec3& target, const Vec3& pole, double upper,
                                double lower) {
  const Vec3 to_target = target - root;
  const double wanted = glm::length(to_target);
  const Vec3 axis = wanted > 1e-12 ? to_target / wanted : Vec3(0, -1, 0);
  const double reach = std::clamp(wanted, std::abs(upper - lower), upper + lower);

  Vec3 side = pole - root;
  side -= axis * glm::dot(axis, side);
  const double side_length = glm::length(side);
  const Vec3 bend = side_length > 1e-9 ? side / side_length : any_perpendicular(axis);

  // Law of cosines: where the middle joint's foot stands on the line from root to end.
  const double along = reach > 1e-12 ? (upper * upper - lower * lower + reach * reach) / (2 * reach) : 0.0;
  const double across = std::sqrt(std::max(0.0, upper * upper - along * along));
  TwoBoneSolution solution;
  solution.middle = root + axis * along + bend * across;
  solution.end = root + axis * reach;
  solution.deficit = std::abs(wanted - reach);
  return solution;
}

Quat swing_between(const Vec3& from, const Vec3& to) {
  const double lengths = glm::length(from) * glm::length(to);
  if (lengths < 1e-18) return Quat(1, 0, 0, 0);
  const double cosine = glm::dot(from, to) / lengths;
  if (cosine < -1 + 1e-12) {
    const Vec3 axis = any_perpendicular(from / glm::length(from));
    return Quat(0, axis.x, axis.y, axis.z);
  }
  const Vec3 axis = glm::cross(from, to) / lengths;
  return glm::normalize(Quat(1 + cosine, axis.x, axis.y, axis.z));
}

}  // namespace posecoach
