// What stands in the wrong place: the clear differences between the two bodies at the events, one a body
// part.
#pragma once

#include <vector>

#include "core/coaching/alignment.h"
#include "core/coaching/analysis.h"
#include "core/coaching/strictness.h"
#include "core/coaching/swing_events.h"
#include "core/coaching/viewpoint.h"

namespace posecoach {

// What is compared: both swings right-handed, the coach turned as the student stands.
struct ComparedSwings {
  const JointTrack& student;
  const SwingEvents& student_events;
  const JointTrack& coach;
  const SwingEvents& coach_events;
  Viewpoints views = {};
  Sight sight = {};  // of the student's camera
  Strictness strictness = {};
  // The coach in his own body, at the same times: how far his arms are bent away from the ball, which closing
  // the grip in another body changes. None: `coach` tells that, too.
  const JointTrack* coach_himself = nullptr;
};

// Clear differences only, the most important first: by how far beyond the ordinary it is and how much of the
// joint error of its moment it explains. At most `most`. Frames are the motions' own.
std::vector<SpatialAdvice> find_spatial_advice(const ComparedSwings& swings, std::size_t most);

}  // namespace posecoach
