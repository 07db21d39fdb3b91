// Arms and legs that reach for a place without popping: the elbow or knee keeps bending the way it did, also
// where the limb is nearly straight and its bend hardly shows.
#pragma once

#include <vector>

#include "core/retarget/posed_motion.h"

namespace posecoach {

struct Limb {
  int root = kNoJoint, middle = kNoJoint, end = kNoJoint;  // shoulder, elbow, wrist; hip, knee, ankle
  int body = kNoJoint;  // whose axes the bend is steady in: chest or pelvis
  Vec3 usual_bend;      // in the body's T-pose axes, where nothing else tells
};

Limb left_arm(const Skeleton& skeleton);
Limb right_arm(const Skeleton& skeleton);
Limb left_leg(const Skeleton& skeleton);
Limb right_leg(const Skeleton& skeleton);

// Elbows and knees lock suddenly: a limb is stretched no further than is comfortable, or than the coach
// stretches his. An arm that must reaches to the full; for a leg the hips give way.
inline constexpr double kComfortableReach = 0.985, kFullReach = 0.9999;  // of its length

// The distance from root to end over the limb's full length, in a frame: 1 is straight.
double stretch(const Motion& motion, int frame, const Limb& limb);

class LimbReacher {
 public:
  // Looks at the motion's bends once, before anything is changed.
  LimbReacher(const PosedMotion& motion, const Limb& limb);

  // From root to end when stretched.
  double reach() const { return upper_ + lower_; }
  // Moves the end to `target`, or as near as it reaches; what hangs on the end keeps its orientation. Returns
  // how far the limb was too short, metres.
  double reach_for(PosedMotion& motion, int frame, const Vec3& target) const;

 private:
  Limb limb_;
  double upper_ = 0, lower_ = 0;
  std::vector<Vec3> bends_;  // of each frame, in the body joint's axes, metres off the straight line
};

// The place nearest to `wanted` that is within both balls; between them, by the ratio of the radii, when they
// do not meet. `gap` is the distance between the balls then, else 0.
struct NearestInBoth {
  Vec3 place;
  double gap = 0;
};
NearestInBoth nearest_in_both(const Vec3& wanted, const Vec3& centre_a, double radius_a, const Vec3& centre_b,
                              double radius_b);

}  // namespace posecoach
