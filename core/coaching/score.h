// From the aligned error to a score; docs/SCORE.md explains it to golfers.
#pragma once

#include "core/coaching/alignment.h"
#include "core/coaching/analysis.h"
#include "core/coaching/film_error.h"
#include "core/coaching/swing_events.h"

namespace posecoach {

// percent = 100 / (1 + (e / h)^1.5), e = mean joint error in leg lengths, h = kHalfScore. Of a film, e is the
// mean over the parts of the body, by their joints, of what is left when a part's usual error is taken off:
// sqrt(e^2 - usual^2), at least 0.
inline constexpr double kHalfScore = 0.10;

double percent_from_error(double mean_joint_error_m, double leg_length_m, double usual_error = 0);

// Hip to knee to ankle, median over the frames, mean of both sides, metres.
double leg_length(const JointTrack& track);

Score score_of(const Alignment& alignment, const UsualFilmError& usual_error);
// Each part of the body by its own joints; parts that the bodies do not share are left out.
std::vector<PartScore> group_scores_of(const Alignment& alignment, const UsualFilmError& usual_error);
// Address to top to impact to the last event, by the student's time along the path.
std::vector<PartScore> phase_scores_of(const Alignment& alignment, const SwingEvents& student,
                                       const UsualFilmError& usual_error);
// Worst first.
std::vector<JointError> joint_errors_of(const Alignment& alignment);
// At most five, at least `apart` seconds of the student's time from each other, worst first.
std::vector<FramePair> worst_frames_of(const Alignment& alignment, const JointTrack& student, double apart_s);

}  // namespace posecoach
