#include "app/analyze/picture_retarget.h"

#include <algorithm>

#include "core/transfer/trained.h"

namespace posecoach {

Result<PoseTrack> load_coach_pictures(const std::string& source, const LoadOptions& options) {
  Result<PoseTrack> track = load_pose_track(source, options);
  if (!track && track.error().code == ErrorCode::Unsupported)
    return fail(ErrorCode::Unsupported, track.error().message +
                                            "; --retarget transfer2d is for a coach of whom there are only "
                                            "pictures, motions need no such help");
  if (!track) return track;
  track->source = source;
  if (std::none_of(track->frames.begin(), track->frames.end(),
                   [](const PoseObservation& frame) { return frame.person.has_value(); }))
    return fail(ErrorCode::NoPerson, source + ": nobody is seen in it");
  return track;
}

Result<FilmedCoach> make_filmed_coach(const PoseTrack& pictures) {
  return filmed_coach_from(pictures, [] { return make_transferer(kDefaultTransferMethod); });
}

Result<AnalyzedPair> analyze_in_picture(const PoseTrack& coach, const LoadedMotion& student,
                                        const AnalyzeOptions& options) {
  if (!student.student)
    return fail(ErrorCode::InvalidArgument,
                student.source +
                    ": --retarget transfer2d draws the coach on the student's pictures, and this "
                    "is a motion without any");
  const Result<FilmedCoach> filmed = make_filmed_coach(coach);
  if (!filmed) return tl::unexpected(filmed.error());
  const LiftedStudent& lifted = student.student->lifted;
  return analyze_in_picture(*filmed, student_from_film(student.source, student.student->track, lifted),
                            lifted, options);
}

}  // namespace posecoach
