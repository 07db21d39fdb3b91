// What the pose stage saw in a whole film, frame by frame.
#pragma once

#include <string>
#include <vector>

#include "core/body/landmarks.h"

namespace posecoach {

struct PoseTrack {
  std::string source;
  int width = 0;  // of the film, pixels, upright (rotation flag applied)
  int height = 0;
  std::vector<PoseObservation> frames;  // in strictly increasing time
};

}  // namespace posecoach
