// From a picture to the person in it. With state (tracking, smoothing): frames come in the order of their
// time.
#pragma once

#include <optional>

#include "core/base/error.h"
#include "core/body/landmarks.h"
#include "core/image/frame.h"

namespace posecoach {

class PoseEstimator {
 public:
  virtual ~PoseEstimator() = default;
  virtual Result<PoseObservation> estimate(const Frame& frame) = 0;
  // The person of the last estimate() as the networks saw him, where that was smoothed: smoothing shows a
  // slow movement late, and pictures are judged as they are. Nothing from a stage that does not smooth.
  virtual std::optional<SeenPerson> unsmoothed() const { return std::nullopt; }
  // How many people are in the picture; nothing from a stage that cannot tell. Takes about as long as
  // estimate(), and does not change what that answers.
  virtual Result<std::optional<int>> count_people(const Frame&) { return std::optional<int>(); }
  // Forgets the tracked person.
  virtual void reset() = 0;
};

}  // namespace posecoach
