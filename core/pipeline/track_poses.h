// A film through the pose stage.
#pragma once

#include <functional>

#include "core/base/progress.h"
#include "core/motion/pose_track.h"
#include "core/pipeline/frame_source.h"
#include "core/pipeline/pose_estimator.h"

namespace posecoach {

struct TrackingSummary {
  std::size_t frames = 0;
  std::size_t frames_with_person = 0;
};

// Hands every frame's answer to `sink`, in order; its error ends the work. Holds one frame at a time. Errors:
// those of source, estimator and sink, and Cancelled.
Result<TrackingSummary> track_poses(FrameSource& source, PoseEstimator& estimator, const Progress& progress,
                                    const std::function<Result<void>(const PoseObservation&)>& sink);

// The same, kept in memory (about 2 kB a frame).
Result<PoseTrack> track_poses(FrameSource& source, PoseEstimator& estimator, const Progress& progress = {});

}  // namespace posecoach
