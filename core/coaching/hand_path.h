// The curves from which a stroke's events are read, at a constant rate.
#pragma once

#include <vector>

#include "core/coaching/joint_track.h"
#include "core/coaching/sight.h"

namespace posecoach {

inline constexpr double kHandPathRate = 120;

struct HandPath {
  // Where the camera's line of sight counts as much as all else: down the line, a backswing starts along it.
  std::vector<Vec3> unweighted_hands;
  std::vector<double> unweighted_speed;
  std::vector<Vec3> hands;                    // middle of the wrists, relative to the pelvis, metres
  std::vector<Vec3> left_wrist, right_wrist;  // the same of each
  std::vector<double> left_confidence, right_confidence;
  std::vector<double> speed;   // of the hands, metres a second
  std::vector<double> height;  // of the hands over the pelvis, metres
  // To the hands from the middle of the shoulders, and from halfway between it and each shoulder, metres.
  std::vector<Vec3> arms, left_arms, right_arms;
  std::vector<Vec3> shoulder_line;  // from right to left, metres
  double begin_s = 0;
  double torso_m = 0;  // pelvis to neck, median: the body's yardstick

  int count() const { return static_cast<int>(hands.size()); }
  double time(double index) const { return begin_s + index / kHandPathRate; }
};

// Smoothing grows with how much the hands tremble: a few milliseconds for mocap, most of a frame for films.
HandPath make_hand_path(const JointTrack& track, const Sight& sight = {});
// The same for a putt: where one camera cannot see the hands' way, the shoulders tell it (pendulum.h), in
// `hands` and `speed`.
HandPath make_putt_path(const JointTrack& track, const Sight& sight = {});

// Angle of the arms above the horizon, degrees.
std::vector<double> elevation_deg(const std::vector<Vec3>& arm);

}  // namespace posecoach
