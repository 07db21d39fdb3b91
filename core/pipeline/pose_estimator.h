// From a picture to the person in it. With state (tracking, smoothing): frames come in the order of their
// time.
#pragma once

#include "core/base/error.h"
#include "core/body/landmarks.h"
#include "core/image/frame.h"

namespace posecoach {

class PoseEstimator {
 public:
  virtual ~PoseEstimator() = default;
  virtual Result<PoseObservation> estimate(const Frame& frame) = 0;
  // Forgets the tracked person.
  virtual void reset() = 0;
};

}  // namespace posecoach
