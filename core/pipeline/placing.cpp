#include "core/pipeline/placing.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace posecoach {

std::array<Vec3, kLandmarkCount> on_rays(const SeenPerson& person, double depth, const Intrinsics& camera) {
  std::array<Vec3, kLandmarkCount> points;
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    const double z = std::max(0.1, depth + person.world[i].position_m.z);
    const Vec2 ray = (person.image[i].position_px - camera.centre_px) / camera.focal_px;
    points[i] = {ray.x * z, ray.y * z, z};
  }
  return points;
}

double arms_legs_and_torso(const Skeleton& body) {
  double sum = 0;
  for (const HumanoidJoint role :
       {HumanoidJoint::Chest, HumanoidJoint::LeftElbow, HumanoidJoint::LeftWrist, HumanoidJoint::RightElbow,
        HumanoidJoint::RightWrist, HumanoidJoint::LeftKnee, HumanoidJoint::LeftAnkle,
        HumanoidJoint::RightKnee, HumanoidJoint::RightAnkle})
    sum += body.bone_length(body.find(role));
  return sum;
}

}  // namespace posecoach
