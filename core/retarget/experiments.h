// What the tables of errors do not show: grips on bodies of other arms and shoulders, and whether an answer
// depends on how a pose came about.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/retarget/evaluation.h"

namespace posecoach {

struct GripRow {
  std::string motion, body;
  double before_cm = 0;   // mean error of the wrists' relation without the constraint
  double p95_cm = 0;      // with it, in frames within reach
  double deficit_cm = 0;  // how far the arms are too short, worst frame
  int unreachable = 0, frames = 0;
  double slide_cm_s = 0, coach_slide_cm_s = 0;  // planted feet, contacts on
};
// Each golf motion on bodies with arms and shoulders 20 % longer and shorter, alone and against each other.
// Errors: those of retarget.
Result<std::vector<GripRow>> grips_on_other_bodies(const std::vector<CharacterMotion>& golf,
                                                   const EvaluatedMethod& method);

// The paper's Figure 2: the same joint positions reached by two histories of rotations (every bone spun about
// itself), retargeted; how far the two results part. 0 for methods that look at positions.
struct HistoryRow {
  std::string method;
  double mean_cm = 0, max_cm = 0;  // over joints and frames, root at the origin
};
Result<std::vector<HistoryRow>> part_by_history(const Motion& coach, const Skeleton& body,
                                                const std::vector<EvaluatedMethod>& methods);

// The same lengths with upper arms, forearms, thighs and shins sloped by `angle` in the rest pose, as rigs
// differ: there a spin of the coach's bone moves the end of the student's.
Skeleton with_sloped_limbs(const Skeleton& body, double angle);

// The same positions with every bone that has one bone after it spun about itself by `angle`. For motions
// with rotations.
Motion with_spun_bones(const Motion& motion, double angle);

}  // namespace posecoach
