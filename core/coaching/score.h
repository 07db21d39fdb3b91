// From the aligned error to a score; docs/SCORE.md explains it to golfers.
#pragma once

#include <optional>

#include "core/coaching/alignment.h"
#include "core/coaching/analysis.h"
#include "core/coaching/film_gaps.h"
#include "core/coaching/swing_events.h"

namespace posecoach {

// percent = 100 / (1 + (e / h)^1.5), e = mean joint error in leg lengths, h = kHalfScore. Of a film, e is the
// mean over the parts of the body, by their joints, of what is beyond a part's usual error when the pose
// stage's habits are taken off, and h = kHalfFilmScore: what is taken off would have cost, too.
inline constexpr double kHalfScore = 0.10, kHalfFilmScore = 0.06;

double percent_from_error(double mean_joint_error_m, double leg_length_m);

// Hip to knee to ankle, median over the frames, mean of both sides, metres.
double leg_length(const JointTrack& track);

// `film`: what a camera saw; none for motion capture.
Score score_of(const Alignment& alignment, const std::optional<FilmGaps>& film);
// Each part of the body by its own joints; parts that the bodies do not share are left out.
std::vector<PartScore> group_scores_of(const Alignment& alignment, const std::optional<FilmGaps>& film);
// Address to top to impact to the last event; by the student's time along the path, of a film by the coach's.
std::vector<PartScore> phase_scores_of(const Alignment& alignment, const SwingEvents& student,
                                       const std::optional<FilmGaps>& film);
// Worst first.
std::vector<JointError> joint_errors_of(const Alignment& alignment);
// At most five, at least `apart` seconds of the student's time from each other, worst first.
std::vector<FramePair> worst_frames_of(const Alignment& alignment, const JointTrack& student, double apart_s);

}  // namespace posecoach
