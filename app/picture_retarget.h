// `analyze --retarget transfer2d`: a coach of whom there is only a film or a picture, carried over in the
// picture plane.
#pragma once

#include "app/load_motion.h"
#include "core/pipeline/analyze.h"

namespace posecoach {

inline constexpr const char* kTransfer2d = "transfer2d";

// What was seen of the coach. Errors: those of load_pose_track; Unsupported for motions, NoPerson.
Result<PoseTrack> load_coach_pictures(const std::string& source, const LoadOptions& options);

// A film of the coach is compared like any motion; a picture with the moment of the student's film that is
// most like it. Errors: InvalidArgument (no pictures of the student), those of lift, coach_in_picture,
// analyze and analyze_picture.
Result<AnalyzedPair> analyze_in_picture(const PoseTrack& coach, const LoadedMotion& student,
                                        const AnalyzeOptions& options);

}  // namespace posecoach
