#include "core/retarget/joint_mapping.h"

#include <glm/geometric.hpp>

#include "core/base/index.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

Result<void> check_complete(const Skeleton& skeleton, const char* whose) {
  std::string missing;
  for (const HumanoidJoint role : {LeftShoulder, LeftElbow, LeftWrist, RightShoulder, RightElbow, RightWrist,
                                   LeftHip, LeftKnee, LeftAnkle, RightHip, RightKnee, RightAnkle})
    if (!skeleton.has(role)) missing += (missing.empty() ? "" : ", ") + std::string(to_string(role));
  if (missing.empty()) return {};
  return fail(ErrorCode::Incomplete, std::string(whose) + " body lacks " + missing +
                                         ": a motion needs both arms and legs to be carried over");
}

// Pelvis and chest are what carries hips and shoulders, whatever the rig calls it; the rest goes by role, and
// extras (fingers) by name.
int source_of(const Skeleton& source, const Skeleton& target, int joint) {
  if (joint == pelvis_joint(target)) return pelvis_joint(source);
  if (joint == chest_joint(target)) return chest_joint(source);
  const Joint& wanted = target.joint(joint);
  if (wanted.role == Pelvis) return pelvis_joint(source);
  if (wanted.role == Chest) return kNoJoint;  // a second chest between chest and neck moves with the chest
  if (wanted.role) return source.find(*wanted.role);
  const int same_name = source.find(wanted.name);
  return same_name != kNoJoint && !source.joint(same_name).role ? same_name : kNoJoint;
}

}  // namespace

Result<JointMapping> map_joints(const Skeleton& source, const Skeleton& target) {
  if (auto ok = check_complete(source, "the coach's"); !ok) return tl::unexpected(ok.error());
  if (auto ok = check_complete(target, "the student's"); !ok) return tl::unexpected(ok.error());
  JointMapping mapping{std::vector<MappedJoint>(index(target.size()))};
  const int pelvis = pelvis_joint(target), chest = chest_joint(target);
  for (int j = 0; j < target.size(); ++j) {
    MappedJoint& mapped = mapping.joints[index(j)];
    mapped.source = source_of(source, target, j);
    if (mapped.source != kNoJoint || !is_ancestor(target, j, pelvis)) continue;
    // Above the pelvis: where the spine branches off it is part of the pelvis, else it carries the whole
    // body.
    if (j == common_ancestor(target, pelvis, chest))
      mapped.source = pelvis_joint(source);
    else
      mapped.above_body = true;
  }
  for (int j = 1; j < target.size(); ++j) {
    const MappedJoint& mapped = mapping.joints[index(j)];
    if (mapped.source == kNoJoint) continue;
    int above = target.joint(j).parent;
    while (above != kNoJoint && mapping.joints[index(above)].source == kNoJoint)
      above = target.joint(above).parent;
    if (above == kNoJoint) continue;
    mapping.joints[index(above)].next.push_back(j);
    mapping.joints[index(above)].next_source.push_back(mapped.source);
  }
  return mapping;
}

}  // namespace posecoach
