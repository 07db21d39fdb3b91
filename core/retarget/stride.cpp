#include "core/retarget/stride.h"

#include <glm/geometric.hpp>

#include "core/body/two_bone_ik.h"
#include "core/retarget/limb.h"

namespace posecoach {
namespace {

// Radians: nearer than this is rounding.
constexpr double kThere = 1e-7;

}  // namespace

void stride_like(const Motion& coach, PosedMotion& student) {
  for (const auto& leg_of : {left_leg, right_leg}) {
    const Limb coach_leg = leg_of(coach.skeleton()), leg = leg_of(student.skeleton());
    for (int f = 0; f < student.frame_count(); ++f) {
      const Vec3 way = coach.position(f, coach_leg.end) - coach.position(f, coach_leg.root);
      const Vec3 now = student.position(f, leg.end) - student.position(f, leg.root);
      const double off = glm::length(glm::cross(now, way)), along = glm::dot(now, way);
      if (along > 0 && off <= kThere * along) continue;
      student.turn(f, leg.root, swing_between(now, way), leg.end);
    }
  }
}

}  // namespace posecoach
