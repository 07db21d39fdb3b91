// A body of average proportions for a given stature: the 25 canonical joints in T-pose, feet on the floor.
// Segment lengths as fractions of stature: Drillis & Contini (1966), as tabulated by Winter, "Biomechanics
// and Motor Control of Human Movement".
#pragma once

#include "core/body/skeleton.h"

namespace posecoach {

// Factors on the average proportions; 1 is average. Left and right alike.
struct BodyProportions {
  double height_m = 1.75;
  double arms = 1.0;
  double forearms = 1.0;
  double shoulders = 1.0;  // breadth
  double torso = 1.0;
  double hips = 1.0;  // breadth
  double thighs = 1.0;
  double shins = 1.0;
};

// Asserts that every factor is in (0, 3] and the height in (0.2, 3).
Skeleton make_standard_body(const BodyProportions& proportions = {});

}  // namespace posecoach
