#include "core/motion/euler.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace posecoach {
namespace {

double nearest_turn(double angle, double previous) {
  return angle - 2 * kPi * std::round((angle - previous) / (2 * kPi));
}

Vec3 nearest_turns(const Vec3& angles, const Vec3& previous) {
  return {nearest_turn(angles.x, previous.x), nearest_turn(angles.y, previous.y),
          nearest_turn(angles.z, previous.z)};
}

}  // namespace

Vec3 unit_vector(Axis axis) {
  return {axis == Axis::X ? 1 : 0, axis == Axis::Y ? 1 : 0, axis == Axis::Z ? 1 : 0};
}

Quat rotation_about(Axis axis, double radians) {
  const double s = std::sin(radians / 2);
  return {std::cos(radians / 2), axis == Axis::X ? s : 0, axis == Axis::Y ? s : 0, axis == Axis::Z ? s : 0};
}

bool is_euler_order(std::span<const Axis> axes) {
  return axes.size() == 3 && axes[0] != axes[1] && axes[1] != axes[2] && axes[0] != axes[2];
}

// With i, j, k the order's axes and e = +1 where they are cyclic: R = Ri(a) Rj(b) Rk(c) has
// R[i][k] = e sin b, R[j][k] = -e sin a cos b, R[k][k] = cos a cos b, R[i][j] = -e cos b sin c,
// R[i][i] = cos b cos c (rows first).
Vec3 euler_angles(const Quat& rotation, const EulerOrder& order, const Vec3& previous) {
  const auto i = static_cast<int>(order[0]), j = static_cast<int>(order[1]), k = static_cast<int>(order[2]);
  const double e = (j - i + 3) % 3 == 1 ? 1.0 : -1.0;
  const Mat3 m = glm::mat3_cast(glm::normalize(rotation));
  const auto at = [&](int row, int column) { return m[column][row]; };
  const double cos_b = std::hypot(at(i, i), at(i, j));
  const double b = std::atan2(e * at(i, k), cos_b);
  if (cos_b < 1e-9) {  // only a + c or a - c counts: keep the first angle where it was
    const double a = previous.x;
    const Quat rest = glm::conjugate(rotation_about(order[1], b)) *
                      glm::conjugate(rotation_about(order[0], a)) * glm::normalize(rotation);
    const double c = 2 * std::atan2(glm::dot(Vec3(rest.x, rest.y, rest.z), unit_vector(order[2])), rest.w);
    return nearest_turns({a, b, c}, previous);
  }
  const double a = std::atan2(-e * at(j, k), at(k, k));
  const double c = std::atan2(-e * at(i, j), at(i, i));
  const Vec3 first = nearest_turns({a, b, c}, previous);
  const Vec3 second = nearest_turns({a + kPi, kPi - b, c + kPi}, previous);
  const auto distance = [&](const Vec3& angles) { return glm::length(angles - previous); };
  return distance(first) <= distance(second) ? first : second;
}

}  // namespace posecoach
