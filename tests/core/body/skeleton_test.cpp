#include "core/body/skeleton.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/body/mirror.h"
#include "core/body/standard_body.h"

namespace posecoach {
namespace {

Joint joint(std::string name, int parent, Vec3 offset = {0, 1, 0}) {
  return {std::move(name), parent, offset, {}};
}

TEST(Skeleton, rejects_child_listed_before_its_parent) {
  const auto made = Skeleton::make({joint("root", kNoJoint), joint("hand", 2), joint("elbow", 0)});
  ASSERT_FALSE(made);
  EXPECT_NE(made.error().message.find("hand"), std::string::npos);
}

TEST(Skeleton, rejects_no_joints_two_roots_equal_names_and_infinite_offsets) {
  EXPECT_FALSE(Skeleton::make({}));
  EXPECT_FALSE(Skeleton::make({joint("a", kNoJoint), joint("b", kNoJoint)}));
  EXPECT_FALSE(Skeleton::make({joint("a", kNoJoint), joint("a", 0)}));
  EXPECT_FALSE(
      Skeleton::make({joint("a", kNoJoint), joint("b", 0, {0, std::numeric_limits<double>::infinity(), 0})}));
}

TEST(Skeleton, mirroring_twice_gives_the_same_body) {
  BodyProportions proportions;
  proportions.arms = 1.2;
  const Skeleton body = make_standard_body(proportions);
  EXPECT_EQ(mirrored(mirrored(body)), body);
}

TEST(Skeleton, every_canonical_name_reads_back) {
  for (const HumanoidJoint role : kHumanoidJoints)
    EXPECT_EQ(humanoid_joint_from_string(to_string(role)), role);
  EXPECT_EQ(humanoid_joint_from_string("tail"), std::nullopt);
}

TEST(Skeleton, mirror_of_a_role_is_an_involution_with_mirrored_parent) {
  for (const HumanoidJoint role : kHumanoidJoints) {
    EXPECT_EQ(mirrored(mirrored(role)), role);
    const auto parent = canonical_parent(role);
    if (!parent) continue;
    EXPECT_EQ(canonical_parent(mirrored(role)), mirrored(*parent)) << to_string(role);
  }
}

}  // namespace
}  // namespace posecoach
