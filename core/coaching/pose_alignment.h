// Pose alignment advice (figure 6 of the Virtual Pose Coach paper): when the golfer should be in which pose.
// Of every event, which moment of the student answers it along the path of the alignment, and how early or
// late that is in the rhythm of the stroke.
#pragma once

#include <vector>

#include "core/coaching/alignment.h"
#include "core/coaching/analysis.h"
#include "core/coaching/spatial_advice.h"

namespace posecoach {

// The joints that a golfer can be told about and that are clearly apart, with the feet at address in one
// place: at most three, farthest first, the two hands as one. Times are the motions' own.
std::vector<JointGap> joints_apart(const Alignment& alignment, double student_s, double coach_s);

// Of the coach's events in their order. Times count from each one's own takeaway.
std::vector<PoseMatch> match_poses(const ComparedSwings& swings, const Alignment& alignment);

}  // namespace posecoach
