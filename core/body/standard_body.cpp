#include "core/body/standard_body.h"

#include "core/base/assert.h"

namespace posecoach {

Skeleton make_standard_body(const BodyProportions& p) {
  for (double factor : {p.arms, p.forearms, p.shoulders, p.torso, p.hips, p.thighs, p.shins})
    POSECOACH_ASSERT(factor > 0 && factor <= 3);
  POSECOACH_ASSERT(p.height_m > 0.2 && p.height_m < 3);
  const double h = p.height_m;
  const double thigh = 0.245 * h * p.thighs;
  const double shin = 0.246 * h * p.shins;
  const double ankle_height = 0.039 * h;
  const double half_hips = 0.052 * h * p.hips;  // hip joints, not the flesh
  const double half_shoulders = 0.109 * h * p.shoulders;
  const double upper_arm = 0.172 * h * p.arms;
  const double forearm = 0.157 * h * p.forearms * p.arms;
  const double torso = 0.288 * h * p.torso;  // hip joints to shoulder line
  const double foot = 0.12 * h;
  const double pelvis_height = ankle_height + shin + thigh + 0.02 * h;

  std::vector<Joint> joints;
  const auto add = [&](HumanoidJoint role, std::optional<HumanoidJoint> parent, Vec3 offset) {
    int parent_index = kNoJoint;
    for (std::size_t i = 0; i < joints.size(); ++i)
      if (parent && joints[i].role == *parent) parent_index = static_cast<int>(i);
    joints.push_back({std::string(to_string(role)), parent_index, offset, role});
  };
  using enum HumanoidJoint;
  add(Pelvis, {}, {0, pelvis_height, 0});
  for (const double side : {1.0, -1.0}) {  // left is +X when the body faces +Z
    const bool left = side > 0;
    const HumanoidJoint hip = left ? LeftHip : RightHip, knee = left ? LeftKnee : RightKnee;
    const HumanoidJoint ankle = left ? LeftAnkle : RightAnkle, toe = left ? LeftToe : RightToe;
    add(hip, Pelvis, {side * half_hips, -0.02 * h, 0});
    add(knee, hip, {0, -thigh, 0});
    add(ankle, knee, {0, -shin, 0});
    add(toe, ankle, {0, -ankle_height * 0.75, foot * 0.75});
    add(left ? LeftToeTip : RightToeTip, toe, {0, -ankle_height * 0.25, foot * 0.30});
  }
  add(Spine, Pelvis, {0, torso * 0.22, 0});
  add(SpineMiddle, Spine, {0, torso * 0.26, 0});
  add(Chest, SpineMiddle, {0, torso * 0.28, 0});
  add(Neck, Chest, {0, torso * 0.24, 0});
  add(Head, Neck, {0, 0.055 * h, 0.01 * h});
  add(HeadTop, Head, {0, 0.107 * h, 0});
  for (const double side : {1.0, -1.0}) {
    const bool left = side > 0;
    const HumanoidJoint clavicle = left ? LeftClavicle : RightClavicle,
                        shoulder = left ? LeftShoulder : RightShoulder;
    const HumanoidJoint elbow = left ? LeftElbow : RightElbow;
    add(clavicle, Chest, {side * half_shoulders * 0.2, torso * 0.20, 0});
    add(shoulder, clavicle, {side * half_shoulders * 0.8, 0, 0});
    add(elbow, shoulder, {side * upper_arm, 0, 0});
    add(left ? LeftWrist : RightWrist, elbow, {side * forearm, 0, 0});
  }
  Result<Skeleton> made = Skeleton::make(std::move(joints));
  POSECOACH_ASSERT(made.has_value());
  return *std::move(made);
}

}  // namespace posecoach
