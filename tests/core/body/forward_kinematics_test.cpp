#include "core/body/forward_kinematics.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

#include "core/body/standard_body.h"

namespace posecoach {
namespace {

Pose random_pose(const Skeleton& body, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Pose pose = rest_pose(body);
  for (Quat& q : pose.rotations)
    q = glm::normalize(Quat(normal(random), normal(random), normal(random), normal(random)));
  return pose;
}

TEST(ForwardKinematics, rest_pose_gives_rest_positions) {
  const Skeleton body = make_standard_body();
  const auto positions = forward_kinematics(body, rest_pose(body));
  for (std::size_t i = 0; i < positions.size(); ++i)
    EXPECT_NEAR(glm::distance(positions[i], body.rest_positions()[i]), 0, 1e-12);
}

TEST(ForwardKinematics, any_pose_keeps_every_bone_length) {
  const Skeleton body = make_standard_body();
  const auto positions = forward_kinematics(body, random_pose(body, 1));
  for (int i = 1; i < body.size(); ++i) {
    const auto parent = static_cast<std::size_t>(body.joint(i).parent);
    EXPECT_NEAR(glm::distance(positions[static_cast<std::size_t>(i)], positions[parent]), body.bone_length(i),
                1e-12);
  }
}

TEST(ForwardKinematics, local_rotations_invert_global_rotations) {
  const Skeleton body = make_standard_body();
  const Pose pose = random_pose(body, 2);
  std::vector<Quat> global(pose.rotations.size()), local(pose.rotations.size());
  global_rotations(body, pose.rotations, global);
  local_rotations(body, global, local);
  for (std::size_t i = 0; i < local.size(); ++i)
    EXPECT_NEAR(std::abs(glm::dot(local[i], pose.rotations[i])), 1, 1e-12);
}

}  // namespace
}  // namespace posecoach
