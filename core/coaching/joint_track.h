// A motion as coaching looks at it: the canonical joints alone, over seconds, whatever rig they came from.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/body/humanoid.h"
#include "core/motion/motion.h"

namespace posecoach {

class JointTrack {
 public:
  // Joints without a canonical role are left out; a missing pelvis is the middle of the hips, a missing neck
  // the middle of the shoulders. Errors: Incomplete naming the joints that coaching cannot do without
  // (shoulders, elbows, wrists, hips, knees, ankles) or saying that there are fewer than five frames.
  static Result<JointTrack> from_motion(const Motion& motion);

  int frame_count() const { return static_cast<int>(times_.size()); }
  // Seconds from the motion's first frame.
  double time(int frame) const { return times_[static_cast<std::size_t>(frame)]; }
  double duration() const { return times_.back() - times_.front(); }
  std::span<const double> times() const { return times_; }
  // Median; frames a second.
  double frame_rate() const;

  bool has(HumanoidJoint joint) const { return column_[static_cast<std::size_t>(joint)] >= 0; }
  std::span<const HumanoidJoint> joints() const { return joints_; }
  const Vec3& position(int frame, HumanoidJoint joint) const { return positions_[index(frame, joint)]; }
  double confidence(int frame, HumanoidJoint joint) const { return confidence_[index(frame, joint)]; }

  // At a constant rate over [begin_s, end_s], which is cut to the track and always reached: positions on a
  // smooth curve through the frames (cubic Hermite, slopes from the neighbours), confidence linear. Frames
  // keep their times.
  JointTrack resampled(double frames_per_second, double begin_s, double end_s) const;
  // At the given times, rising, clamped to the track.
  JointTrack at(std::vector<double> times_s) const;

  // One frame: the mean over a short time, read from the curve at five instants.
  JointTrack averaged(double begin_s, double end_s) const;
  // Left and right exchanged, x -> -x: bit for bit the track of the mirrored motion.
  JointTrack mirrored() const;
  // Every position passed through `map`.
  template <typename Map>
  JointTrack mapped(const Map& map) const {
    JointTrack track = *this;
    for (Vec3& position : track.positions_) position = map(position);
    return track;
  }

  // The frame nearest to a time, and the time's fractional frame number.
  int nearest_frame(double time_s) const;
  double fractional_frame(double time_s) const;

 private:
  JointTrack() { column_.fill(-1); }
  void add_joint(HumanoidJoint joint);
  std::size_t index(int frame, HumanoidJoint joint) const {
    return static_cast<std::size_t>(frame) * joints_.size() +
           static_cast<std::size_t>(column_[static_cast<std::size_t>(joint)]);
  }
  // The last frame at or before a time, but never the last of all.
  int frame_before(double time_s) const;

  std::vector<HumanoidJoint> joints_;
  std::array<int, kHumanoidJointCount> column_{};
  std::vector<double> times_;
  std::vector<Vec3> positions_;  // frame * joints + column
  std::vector<double> confidence_;
};

}  // namespace posecoach
