#include "core/motion/euler.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

namespace posecoach {
namespace {

constexpr EulerOrder kOrders[] = {{Axis::X, Axis::Y, Axis::Z}, {Axis::Y, Axis::Z, Axis::X},
                                  {Axis::Z, Axis::X, Axis::Y}, {Axis::X, Axis::Z, Axis::Y},
                                  {Axis::Z, Axis::Y, Axis::X}, {Axis::Y, Axis::X, Axis::Z}};

Quat from_angles(const Vec3& angles, const EulerOrder& order) {
  return rotation_about(order[0], angles.x) * rotation_about(order[1], angles.y) *
         rotation_about(order[2], angles.z);
}
double difference(const Quat& a, const Quat& b) {
  return 1 - std::abs(glm::dot(a, b));
}

TEST(EulerAngles, make_the_rotation_again_in_every_order) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(-kPi, kPi);
  for (int i = 0; i < 500; ++i)
    for (const EulerOrder& order : kOrders) {
      const Quat rotation = from_angles({angle(random), angle(random), angle(random)}, order);
      EXPECT_LT(difference(from_angles(euler_angles(rotation, order), order), rotation), 1e-14);
    }
}

TEST(EulerAngles, hold_where_the_middle_angle_is_a_right_one) {
  for (const EulerOrder& order : kOrders)
    for (const double b : {kPi / 2, -kPi / 2}) {
      const Quat rotation = from_angles({0.7, b, -0.4}, order);
      const Vec3 angles = euler_angles(rotation, order, {0.2, 0, 0});
      EXPECT_LT(difference(from_angles(angles, order), rotation), 1e-14);
      EXPECT_NEAR(angles.x, 0.2, 1e-12);
    }
}

TEST(EulerAngles, stay_near_the_previous_ones_over_many_turns) {
  Vec3 previous(0);
  for (int i = 0; i < 400; ++i) {
    const double turn = 0.05 * i;  // more than three full turns
    const Vec3 angles = euler_angles(from_angles({0.3, turn, 0.1}, kOrders[0]), kOrders[0], previous);
    EXPECT_LT(glm::distance(angles, previous), i == 0 ? 1.0 : 0.1);
    previous = angles;
  }
  EXPECT_NEAR(previous.y, 0.05 * 399, 1e-9);
}

}  // namespace
}  // namespace posecoach
