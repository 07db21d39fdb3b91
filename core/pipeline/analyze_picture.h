// One picture of the coach against the student's film: which moment of the film is most like it, and what
// differs there across the view. Nothing can be said about time.
#pragma once

#include "core/pipeline/analyze.h"

namespace posecoach {

// `coach` stands in the student's world (core/pipeline/picture_coach.h); its first frame is the picture. The
// analysis has one pair of frames, no events, no timing and no metrics. Errors: Incomplete (the student is
// not seen well enough in any frame).
Result<AnalyzedPair> analyze_picture(const StudentInput& student, const CoachInput& coach);

}  // namespace posecoach
