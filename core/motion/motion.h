// A body in motion: joint positions over time in the world frame (right-handed, +Y up, metres), with the
// skeleton whose T-pose they belong to, and, where the source knew them, joint rotations. Valid by
// construction: at least one frame, strictly increasing times, finite numbers.
#pragma once

#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/base/time.h"
#include "core/body/skeleton.h"

namespace posecoach {

class Motion {
 public:
  // Frame-major arrays: element frame * skeleton.size() + joint. Errors: Incomplete (no frames), Malformed
  // (sizes that do not fit, times that do not increase, numbers that are not finite), each naming the frame.
  static Result<Motion> from_rotations(Skeleton skeleton, std::vector<MediaTime> times,
                                       std::vector<Vec3> root_positions, std::vector<Quat> local_rotations);
  // Bone lengths may vary from frame to frame (webcam, markers). `confidence` in [0, 1], or empty for 1
  // everywhere; a joint that was not seen has confidence 0 and any finite position, best an interpolated one.
  static Result<Motion> from_positions(Skeleton skeleton, std::vector<MediaTime> times,
                                       std::vector<Vec3> positions, std::vector<double> confidence = {});

  const Skeleton& skeleton() const { return skeleton_; }
  int frame_count() const { return static_cast<int>(times_.size()); }
  int joint_count() const { return skeleton_.size(); }
  MediaTime time(int frame) const { return times_[index(frame)]; }
  std::span<const MediaTime> times() const { return times_; }
  Duration duration() const { return times_.back() - times_.front(); }
  // Median frame rate; 0 for a single frame.
  double frame_rate() const;

  std::span<const Vec3> positions(int frame) const { return {&positions_[first(frame)], row()}; }
  const Vec3& position(int frame, int joint) const { return positions_[first(frame) + index(joint)]; }
  double confidence(int frame, int joint) const {
    return confidence_.empty() ? 1.0 : confidence_[first(frame) + index(joint)];
  }
  bool has_rotations() const { return !rotations_.empty(); }
  // Local rotations; only where has_rotations().
  std::span<const Quat> rotations(int frame) const;

  // Frames [begin, end). Asserts a range that is not empty.
  Motion slice(int begin, int end) const;

 private:
  Motion(Skeleton skeleton, std::vector<MediaTime> times, std::vector<Vec3> positions,
         std::vector<Quat> rotations, std::vector<double> confidence);
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  std::size_t row() const { return index(skeleton_.size()); }
  std::size_t first(int frame) const { return index(frame) * row(); }

  Skeleton skeleton_;
  std::vector<MediaTime> times_;
  std::vector<Vec3> positions_;
  std::vector<Quat> rotations_;
  std::vector<double> confidence_;
};

// The motion at given times, which must increase strictly: positions linearly, rotations spherically between
// the two nearest frames; times outside are clamped to the ends.
Motion resample(const Motion& motion, std::span<const MediaTime> times);
// At a constant rate from the first to the last frame.
Motion resample(const Motion& motion, double frames_per_second);

// The mirror image (x -> -x, left and right exchanged): a left-handed swing becomes a right-handed one. An
// involution.
Motion mirrored(const Motion& motion);

}  // namespace posecoach
