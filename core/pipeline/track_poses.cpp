#include "core/pipeline/track_poses.h"

namespace posecoach {

Result<TrackingSummary> track_poses(FrameSource& source, PoseEstimator& estimator, const Progress& progress,
                                    const std::function<Result<void>(const PoseObservation&)>& sink) {
  const auto expected = source.info().frame_count;
  TrackingSummary summary;
  while (true) {
    const double fraction =
        expected && *expected > 0
            ? std::min(1.0, static_cast<double>(summary.frames) / static_cast<double>(*expected))
            : -1.0;
    if (!report(progress, "poses", fraction))
      return fail(ErrorCode::Cancelled, "interrupted while looking for poses in " + source.info().name);
    const auto frame = source.next({});
    if (!frame) return tl::unexpected(frame.error());
    if (!*frame) return summary;
    const auto seen = estimator.estimate(**frame);
    if (!seen) return tl::unexpected(seen.error());
    ++summary.frames;
    if (seen->person) ++summary.frames_with_person;
    if (const auto taken = sink(*seen); !taken) return tl::unexpected(taken.error());
  }
}

Result<PoseTrack> track_poses(FrameSource& source, PoseEstimator& estimator, const Progress& progress) {
  PoseTrack track;
  track.source = source.info().name;
  track.width = source.info().width;
  track.height = source.info().height;
  const auto done =
      track_poses(source, estimator, progress, [&](const PoseObservation& seen) -> Result<void> {
        track.frames.push_back(seen);
        return {};
      });
  if (!done) return tl::unexpected(done.error());
  return track;
}

}  // namespace posecoach
