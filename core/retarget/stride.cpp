#include "core/retarget/stride.h"

#include <glm/geometric.hpp>

#include "core/retarget/limb.h"
#include "core/retarget/t_pose.h"

namespace posecoach {
namespace {

// Nearer than this, in leg lengths, a foot stands where it should: straight knees turn rounding errors into
// much larger ones.
constexpr double kThere = 1e-7;

double stretched(const TPose& t_pose, const Limb& limb) {
  return glm::distance(t_pose.positions[static_cast<std::size_t>(limb.root)],
                       t_pose.positions[static_cast<std::size_t>(limb.end)]);
}

}  // namespace

void stride_like(const Motion& coach, PosedMotion& student) {
  const TPose coach_t_pose = make_t_pose(coach.skeleton()), t_pose = make_t_pose(student.skeleton());
  for (const auto& leg_of : {left_leg, right_leg}) {
    const Limb coach_leg = leg_of(coach.skeleton()), leg = leg_of(student.skeleton());
    const double ratio = stretched(t_pose, leg) / stretched(coach_t_pose, coach_leg);
    const LimbReacher reacher(student, leg);
    for (int f = 0; f < student.frame_count(); ++f) {
      const Vec3 way = coach.position(f, coach_leg.end) - coach.position(f, coach_leg.root);
      const Vec3 target = student.position(f, leg.root) + ratio * way;
      if (glm::distance(target, student.position(f, leg.end)) > kThere * reacher.reach())
        reacher.reach_for(student, f, target);
    }
  }
}

}  // namespace posecoach
