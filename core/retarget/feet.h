// Feet that stand where the coach's stand: found from the coach's speed and height, held still in the
// student.
#pragma once

#include <array>
#include <vector>

#include "core/motion/motion.h"
#include "core/retarget/posed_motion.h"

namespace posecoach {

struct PlantedFoot {
  int begin = 0, end = 0;  // frames [begin, end)
};
struct FootContacts {
  std::vector<PlantedFoot> left, right;  // in order of time, apart from each other
};

// A foot is planted while its toes (ball of the foot; the ankle where a rig has none) are slow and near the
// floor for at least 0.12 s. Speeds and heights count relative to the legs' length.
FootContacts find_foot_contacts(const Motion& coach);

// Ankles go the coach's ways in leg lengths, planted feet stand still on the student's floor; the legs
// follow, and the hips where a leg is too short.
void plant_feet(const Motion& coach, PosedMotion& student);

}  // namespace posecoach
