// A skeleton as the golfer poser needs it: the limbs, the chain of the back and the feet, found by role.
#pragma once

#include <array>
#include <vector>

#include "core/base/error.h"
#include "core/body/skeleton.h"

namespace posecoach {

// Shoulder-elbow-wrist or hip-knee-ankle at rest.
struct Limb {
  int upper = kNoJoint, middle = kNoJoint, end = kNoJoint;
  double upper_length = 0, lower_length = 0;
  Vec3 upper_rest, lower_rest;  // unit
  Vec3 bend_rest;               // unit: where the middle joint goes when the limb bends
  double length() const { return upper_length + lower_length; }
  // The distance from its root to its end when the middle joint is bent by this angle from straight.
  double reach(double flexion) const;
};

struct GolferBody {
  enum Side { Lead = 0, Trail = 1 };  // of a right-hander: left and right

  // Errors: Incomplete naming the joints that a golfer needs and this skeleton lacks.
  static Result<GolferBody> make(const Skeleton& skeleton);

  Skeleton skeleton;
  int pelvis = kNoJoint;
  std::vector<int> back = {};  // joints that turn between pelvis and chest, the chest last
  std::vector<int> neck = {};  // joints that turn between chest and head, the head last; may be empty
  int chest = kNoJoint;        // carries the arms
  std::array<Limb, 2> arms = {}, legs = {};
  std::array<int, 2> clavicles{kNoJoint, kNoJoint};
  std::array<int, 2> toes{kNoJoint, kNoJoint};
  std::array<Vec3, 2> ankle_to_toe = {};  // rest; to the ball of the toes
  double ankle_height = 0;                // over the sole, at rest
  double hip_distance = 0;
  // Of a standard body of 1.80 m, for which the scripts are written.
  double usual_shoulder_distance = 0, usual_hip_distance = 0;
  double size = 1;  // leg length over that of a standard body of 1.80 m: scales centimetres of the script

  Vec3 middle_of_hips_from_pelvis = {};  // rest
};

}  // namespace posecoach
