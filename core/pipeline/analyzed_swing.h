// One swing with everything known about it: what the instant replay and the review show, what the library
// keeps. Made live from the last seconds, or from a stored film.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "core/base/error.h"
#include "core/image/frame.h"
#include "core/motion/pose_track.h"
#include "core/pipeline/analyze.h"
#include "core/pipeline/lift.h"

namespace posecoach {

// The pictures of a swing in any order. Called from one thread at a time.
class PictureStore {
 public:
  virtual ~PictureStore() = default;
  virtual std::size_t count() const = 0;
  virtual MediaTime time(std::size_t index) const = 0;
  // Errors: a damaged or vanished film.
  virtual Result<std::shared_ptr<const Image>> picture(std::size_t index) = 0;
};

struct AnalyzedSwing {
  PoseTrack track;        // frame k of it is picture k
  LiftedStudent student;  // its motion's frame 0 is picture student.first_frame
  AnalyzedPair pair;      // frames of the student are pictures, of the coach are frames of pair.coach
  std::shared_ptr<PictureStore> pictures;
};

}  // namespace posecoach
