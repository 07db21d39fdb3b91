// A coach of whom there is only a film or a picture, as the commands and the window get him.
#pragma once

#include "app/load_motion.h"
#include "core/pipeline/filmed_coach.h"

namespace posecoach {

// What was seen of the coach. Errors: those of load_pose_track; Unsupported for motions, NoPerson.
Result<PoseTrack> load_coach_pictures(const std::string& source, const LoadOptions& options);

// With the transfer that was measured best. Errors: those of filmed_coach_from.
Result<FilmedCoach> make_filmed_coach(const PoseTrack& pictures);

// `analyze --retarget transfer2d`. Errors: InvalidArgument (no pictures of the student), those of
// make_filmed_coach and of core/pipeline's analyze_in_picture.
Result<AnalyzedPair> analyze_in_picture(const PoseTrack& coach, const LoadedMotion& student,
                                        const AnalyzeOptions& options);

}  // namespace posecoach
