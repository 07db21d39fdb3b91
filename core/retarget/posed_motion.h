// A motion while its pose is being corrected: global rotations and root places that can be changed frame by
// frame, with bone lengths that cannot.
#pragma once

#include <span>
#include <vector>

#include "core/motion/motion.h"

namespace posecoach {

class PosedMotion {
 public:
  // A motion without rotations takes the nearest pose of its skeleton.
  explicit PosedMotion(const Motion& motion);
  Motion motion() const;

  const Skeleton& skeleton() const { return skeleton_; }
  std::span<const MediaTime> times() const { return times_; }
  int frame_count() const { return static_cast<int>(times_.size()); }

  std::span<const Vec3> positions(int frame) const { return row(positions_, frame); }
  const Vec3& position(int frame, int joint) const {
    return positions(frame)[static_cast<std::size_t>(joint)];
  }
  const Quat& rotation(int frame, int joint) const {  // global
    return row(global_, frame)[static_cast<std::size_t>(joint)];
  }

  void shift(int frame, const Vec3& by);
  // Turns `joint` and all that hangs on it by `turn` (world axes), except what hangs on `except` (itself
  // included; kNoJoint: nothing), which keeps its orientation.
  void turn(int frame, int joint, const Quat& turn, int except = kNoJoint);

 private:
  template <typename T>
  std::span<const T> row(const std::vector<T>& all, int frame) const {
    const auto size = static_cast<std::size_t>(skeleton_.size());
    return std::span(all).subspan(static_cast<std::size_t>(frame) * size, size);
  }
  void update(int frame);

  Skeleton skeleton_;
  std::vector<MediaTime> times_;
  std::vector<Vec3> roots_, positions_;
  std::vector<Quat> global_;
};

}  // namespace posecoach
