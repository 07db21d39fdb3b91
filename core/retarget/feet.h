// Feet that stand where the coach's stand: found from the coach's speeds and heights, held still in the
// student.
#pragma once

#include <vector>

#include "core/motion/motion.h"
#include "core/retarget/posed_motion.h"

namespace posecoach {

// What of a foot stays in its place: the ankle while the heel is down, else the ball of the foot.
enum class FootAnchor { Ankle, Toe };

struct PlantedFoot {
  int begin = 0, end = 0;  // frames [begin, end)
  FootAnchor anchor = FootAnchor::Ankle;
};
struct FootContacts {
  // In order of time. Neighbours without a gap are one stance: the heel comes up or down.
  std::vector<PlantedFoot> left, right;
  double floor_m = 0;  // below the coach, in his world: where his soles are in these stances
};

// A foot is planted while ankle or toes are slow and near the height at which they usually stand, for at
// least 0.12 s. Speeds and heights count relative to the legs' length. A rig without toes has ankles only.
FootContacts find_foot_contacts(const Motion& coach);

// The joint that a contact holds, on any body: the ankle where the body has no toes.
int anchor_joint(const Skeleton& skeleton, FootAnchor anchor, bool left);

// Planted feet stand still on the coach's floor (its height scaled like the path); the legs follow, and the
// hips where a leg is too short.
void plant_feet(const Motion& coach, PosedMotion& student);

}  // namespace posecoach
