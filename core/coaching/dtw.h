// Exact dynamic time warping of two sequences of poses: the pairing of frames, both never going back, that
// has the smallest summed cost. Steps advance the student, the coach, or both by one frame (no window, no
// heuristics), so the path is optimal; ties prefer the step that advances both, then the student's.
// Memory: one byte a pair of frames and two rows (two minutes at 60 fps against the same: 52 MB).
#pragma once

#include <span>
#include <utility>
#include <vector>

namespace posecoach {

// Joint positions for the warp: metres relative to the root, frames running fastest (joint * stride + frame),
// single precision so that eight frames fit one vector register. `stride` rounds the frames up; the padding
// is zero.
class PoseSequence {
 public:
  PoseSequence(int frames, int joints);

  int frames() const { return frames_; }
  int joints() const { return joints_; }
  // `weight` says how much to believe this joint in this frame, 0 to 1.
  void set(int frame, int joint, float x, float y, float z, float weight = 1);
  // Whether every weight is one; the warp is faster then.
  bool is_certain() const { return certain_; }

  std::span<const float> x(int joint) const { return row(x_, joint); }
  std::span<const float> y(int joint) const { return row(y_, joint); }
  std::span<const float> z(int joint) const { return row(z_, joint); }
  std::span<const float> weight(int joint) const { return row(weight_, joint); }

 private:
  std::span<const float> row(const std::vector<float>& all, int joint) const {
    return {all.data() + static_cast<std::size_t>(joint) * stride_, stride_};
  }

  int frames_, joints_;
  std::size_t stride_;
  bool certain_ = true;
  std::vector<float> x_, y_, z_, weight_;
};

enum class WarpEnds {
  Closed,      // first frames meet, last frames meet
  OpenStudent  // the whole coach is found somewhere inside the student
};

struct Warp {
  std::vector<std::pair<int, int>> path;  // (student frame, coach frame)
  double cost = 0;                        // summed along the path
};

// Cost of a pair of frames: the summed distance of the joints, in metres. Doubtful joints count less and the
// others more in their place, so that doubt by itself makes no pair cheaper or dearer. Asserts at least one
// frame each and the same joints.
Warp warp(const PoseSequence& student, const PoseSequence& coach, WarpEnds ends = WarpEnds::Closed);

// The same over a given matrix of costs, row = student frame, `columns` = coach frames.
Warp warp(std::span<const float> costs, int columns, WarpEnds ends = WarpEnds::Closed);

// The costs of one frame of the student against every frame of the coach, as the warp adds them up. `costs`
// becomes at least coach.frames() long.
void cost_row(const PoseSequence& student, int student_frame, const PoseSequence& coach,
              std::vector<float>& costs);

// The cost of one pair as the warp sees it, in double precision.
double pair_cost(const PoseSequence& student, int student_frame, const PoseSequence& coach, int coach_frame);

}  // namespace posecoach
