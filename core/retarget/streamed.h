// Retargeting frame by frame: a coach's frame in, the student's frame out, looking back only, in memory that
// does not grow. `posecoach retarget --stream` and `posecoach bench` show what it gives and costs. The
// window's live loop does without: there the coach is known whole beforehand and better retargeted whole; the
// student, who comes as a stream, is measured and not carried over.
#pragma once

#include <deque>
#include <span>
#include <vector>

#include "core/retarget/retarget.h"

namespace posecoach {

// Without contacts: those need to know how long a foot or a grip will hold. What a whole motion's answer
// takes from the frames that follow is missing here, so a filmed coach shakes a little more.
class StreamedRetargeter {
 public:
  // `options.contacts` and `options.rotations` are ignored: the positions count. `memory_s`: how far back
  // answers look that need more than the frame itself.
  StreamedRetargeter(Skeleton coach, Skeleton body, RetargetOptions options, double memory_s = 0.8);

  // Positions and confidences of the coach's joints; times must increase. The student's pose as a motion of
  // one frame. Errors: Malformed (a time that does not increase, numbers that are not finite), those of
  // retarget.
  Result<Motion> push(MediaTime time, std::span<const Vec3> positions, std::span<const double> confidence);
  void reset() { frames_.clear(); }

 private:
  struct Frame {
    MediaTime time;
    std::vector<Vec3> positions;
    std::vector<double> confidence;
  };

  Skeleton coach_, body_;
  RetargetOptions options_;
  double memory_s_;
  std::deque<Frame> frames_;
};

// Every frame of a motion through the above; what a stream would have given.
Result<RetargetResult> retarget_streamed(const Motion& coach, const Skeleton& body,
                                         const RetargetOptions& options = {});

}  // namespace posecoach
