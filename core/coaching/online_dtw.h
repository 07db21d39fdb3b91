// The warp of core/coaching/dtw.h while the student still moves: which frame of the coach answers the pose of
// this instant. Open at its end, one row of the matrix at a time, so a pose costs O(coach frames). The answer
// never goes back, and goes forward by a bounded number of frames a pose. Both at the same constant rate.
//
// The steps and costs are those of the offline warp, so the row's smallest value belongs to the best way of
// pairing all poses so far; only what comes later, which the offline path knows, is missing.
#pragma once

#include <vector>

#include "core/coaching/dtw.h"

namespace posecoach {

class OnlineWarp {
 public:
  // `look_ahead`: the most frames of the coach that one pose may go forward; at least 1.
  OnlineWarp(PoseSequence coach, int look_ahead);

  // `student` is one pose, with the coach's joints. Returns position().
  int step(const PoseSequence& student);
  int position() const { return position_; }
  // Back to the coach's first frame.
  void reset();

  // Mean distance a joint between a pose and one frame of the coach, metres.
  double distance_m(const PoseSequence& student, int coach_frame) const;
  const PoseSequence& coach() const { return coach_; }

 private:
  PoseSequence coach_;
  int look_ahead_;
  int position_ = 0;
  bool is_first_ = true;
  std::vector<double> row_, above_;
  std::vector<float> costs_;
};

}  // namespace posecoach
