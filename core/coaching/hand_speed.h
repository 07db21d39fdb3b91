// How fast hands and feet are, frame by frame: what tells standing still from moving.
#pragma once

#include <deque>

#include "core/base/time.h"
#include "core/coaching/joint_moment.h"
#include "core/coaching/sight.h"

namespace posecoach {

class HandSpeed {
 public:
  // A gap of over half a second begins anew.
  void step(MediaTime time, const JointMoment& student, const Sight& sight);
  void reset() { *this = HandSpeed(); }

  // Of the middle of the wrists over the pelvis, and of the middle of the ankles over the ground, metres a
  // second: between the means of the two halves of the last fifth of a second, so that trembling is no speed.
  double hands() const { return hands_; }
  double feet() const { return feet_; }
  // How long both have been slow, seconds.
  double still_s() const { return still_s_; }

 private:
  struct Places {
    MediaTime time;
    Vec3 hands, feet;
  };
  std::deque<Places> places_;
  double hands_ = 0, feet_ = 0, still_s_ = 0;
};

}  // namespace posecoach
