#include "core/body/standard_body.h"

#include <gtest/gtest.h>

namespace posecoach {
namespace {

TEST(StandardBody, has_every_canonical_joint_and_stands_on_the_floor) {
  const Skeleton body = make_standard_body();
  for (const HumanoidJoint role : kHumanoidJoints) EXPECT_TRUE(body.has(role)) << to_string(role);
  double lowest = 1;
  for (const Vec3& p : body.rest_positions()) lowest = std::min(lowest, p.y);
  EXPECT_NEAR(lowest, 0, 1e-9);
}

TEST(StandardBody, an_average_body_is_as_tall_as_asked) {
  BodyProportions proportions;
  proportions.height_m = 1.80;
  EXPECT_NEAR(make_standard_body(proportions).rest_height(), 1.80, 0.03);
}

TEST(StandardBody, left_is_plus_x_when_facing_plus_z) {
  const Skeleton body = make_standard_body();
  const auto at = [&](HumanoidJoint role) {
    return body.rest_positions()[static_cast<std::size_t>(body.find(role))];
  };
  EXPECT_GT(at(HumanoidJoint::LeftWrist).x, 0.5);
  EXPECT_LT(at(HumanoidJoint::RightWrist).x, -0.5);
  EXPECT_GT(at(HumanoidJoint::LeftToe).z, at(HumanoidJoint::LeftAnkle).z);
}

}  // namespace
}  // namespace posecoach
