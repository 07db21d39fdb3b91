// From the aligned error to a score; docs/SCORE.md explains it to golfers.
#pragma once

#include "core/coaching/alignment.h"
#include "core/coaching/analysis.h"
#include "core/coaching/swing_events.h"

namespace posecoach {

// percent = 100 / (1 + (e / h)^1.5), e = mean joint error in leg lengths, h = kHalfScore.
inline constexpr double kHalfScore = 0.10;

double percent_from_error(double mean_joint_error_m, double leg_length_m);

// Hip to knee to ankle, median over the frames, mean of both sides, metres.
double leg_length(const JointTrack& track);

Score score_of(const Alignment& alignment);
// Each part of the body by its own joints; parts that the bodies do not share are left out.
std::vector<PartScore> group_scores_of(const Alignment& alignment);
// Address to top to impact to the last event, by the student's time along the path.
std::vector<PartScore> phase_scores_of(const Alignment& alignment, const SwingEvents& student);
// Worst first.
std::vector<JointError> joint_errors_of(const Alignment& alignment);
// At most five, at least `apart` seconds of the student's time from each other, worst first.
std::vector<FramePair> worst_frames_of(const Alignment& alignment, const JointTrack& student, double apart_s);

}  // namespace posecoach
