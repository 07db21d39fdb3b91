// A golfer of balls and cones around a skeleton: skin, hair, eyes, a blue shirt, dark trousers, white shoes,
// and the club in his hands. It knows where its own landmarks are, so that a film of it has a truth.
#pragma once

#include <optional>
#include <string>

#include "capture/round_cone.h"
#include "core/body/landmarks.h"
#include "core/motion/authored/golfer_poser.h"

namespace posecoach {

class GolferFigure {
 public:
  // The skeleton must have the joints that GolferBody needs.
  explicit GolferFigure(const Skeleton& skeleton);

  // One pose: world joint positions and world joint rotations, one element a joint.
  struct Posed {
    std::span<const Vec3> positions;
    std::span<const Quat> rotations;
    ClubPose club;
    bool is_putter = false;
    std::optional<Vec3> ball;
  };
  ConeScene scene(const Posed& posed) const;
  // The landmarks of the pose stage on this figure; world, metres.
  LandmarkArray<Vec3> landmarks(const Posed& posed) const;

 private:
  struct Body;
  Body place(const Posed& posed) const;

  Skeleton skeleton_;
  double size_ = 1;     // stature over 1.80 m, for flesh
  double breadth_ = 1;  // of the shoulders, likewise
  double hips_ = 1;
  Vec3 sole_[2];  // under the ankle, in the foot's axes
  Vec3 toe_tip_[2];
};

}  // namespace posecoach
