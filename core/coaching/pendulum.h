// A putter's hands hang from the shoulders and swing as far as the shoulder line rocks about the spine. Down
// the line the hands swing along the line of sight, where a camera sees nothing (half a centimetre across the
// picture), but the shoulder line turns across it: one shoulder rises and the other falls by two centimetres
// each. What the camera cannot see of the hands' way is read from there.
#pragma once

#include <span>

#include "core/coaching/joint_moment.h"
#include "core/coaching/joint_track.h"
#include "core/coaching/sight.h"

namespace posecoach {

// How a golfer stands to a putt; metres, world.
struct PuttPosture {
  Vec3 left;   // across the body, to his left hand's side
  Vec3 spine;  // from the hips to the shoulders
  Vec3 arms;   // from the shoulders to the hands
  double shoulder_width_m = 0;
};
PuttPosture putt_posture(const JointMoment& moment);
PuttPosture between(const PuttPosture& from, const PuttPosture& to, double part);
// Its mean over the track.
PuttPosture putt_posture(const JointTrack& track);

class Pendulum {
 public:
  Pendulum(const PuttPosture& posture, const Sight& sight);

  // `hands` over the pelvis, as they are to be compared: like Sight::seen(), but along the line of sight they
  // lie where the shoulder line (from right to left) says, but for a constant. Without a sight they are
  // unchanged, and from in front, where it runs across the target line, seen() is all there is.
  Vec3 hands(const Vec3& hands, const Vec3& shoulder_line) const;

 private:
  Sight sight_;
  double model_share_ = Sight::kDepthWeight;  // of the pose model's depth
  Vec3 way_from_shoulders_;                   // along the line of sight, metres per metre of shoulder line
};

}  // namespace posecoach
