#include "app/picture_retarget.h"

#include <algorithm>

#include "core/pipeline/analyze_picture.h"
#include "core/pipeline/picture_coach.h"
#include "core/transfer/trained.h"

namespace posecoach {
namespace {

// Fewer pictures of the coach than this are no motion.
constexpr std::ptrdiff_t kFewestOfAFilm = 8;
// A mirror image has to be that much more like the student to be believed.
constexpr double kClearlyBetter = 0.8;

bool is_film(const PoseTrack& track) {
  return std::count_if(track.frames.begin(), track.frames.end(), [](const PoseObservation& frame) {
           return frame.person.has_value();
         }) >= kFewestOfAFilm;
}

struct Student {
  StudentInput input;
  const LiftedStudent& lifted;
};

Result<AnalyzedPair> analyze_film(const LiftedStudent& coach, const std::string& source,
                                  const Student& student, const AnalyzeOptions& options,
                                  Transferer& transferer) {
  // The two must show the same side of a swing, so the coach's film is mirrored, not his motion.
  const Handedness hand = options.hand.value_or(hand_of(student.input.motion, student.input.sight)),
                   his = hand_of(coach.motion);
  const Result<PictureCoach> carried =
      coach_in_picture(hand == his ? coach : mirrored(coach), student.lifted, transferer);
  if (!carried) return tl::unexpected(carried.error());
  Result<AnalyzedPair> pair = analyze(student.input, {source, carried->motion}, options);
  if (!pair) return pair;
  pair->analysis.contacts = false;
  pair->analysis.notes.insert(pair->analysis.notes.end(), carried->doubts.begin(), carried->doubts.end());
  return pair;
}

Result<AnalyzedPair> analyze_still(const LiftedStudent& coach, const std::string& source,
                                   const Student& student, Transferer& transferer) {
  std::optional<AnalyzedPair> best;
  std::string reason;
  ErrorCode code = ErrorCode::Incomplete;
  // Nobody knows from a picture which hand the coach plays with.
  for (const bool is_mirrored : {false, true}) {
    const Result<PictureCoach> carried =
        coach_in_picture(is_mirrored ? mirrored(coach) : coach, student.lifted, transferer);
    if (!carried) return tl::unexpected(carried.error());
    Result<AnalyzedPair> pair = analyze_picture(student.input, {source, carried->motion});
    if (!pair) {
      code = pair.error().code;
      reason = pair.error().message;
      continue;
    }
    if (best &&
        pair->analysis.score.mean_joint_error_m > kClearlyBetter * best->analysis.score.mean_joint_error_m)
      continue;
    std::vector<std::string>& notes = pair->analysis.notes;
    if (is_mirrored) notes.push_back("The coach's picture is mirrored: so it is more like the student.");
    notes.insert(notes.end(), carried->doubts.begin(), carried->doubts.end());
    best = *std::move(pair);
  }
  if (!best) return fail(code, reason);
  return *std::move(best);
}

}  // namespace

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

Result<AnalyzedPair> analyze_in_picture(const PoseTrack& coach, const LoadedMotion& student,
                                        const AnalyzeOptions& options) {
  if (!student.student)
    return fail(ErrorCode::InvalidArgument,
                student.source +
                    ": --retarget transfer2d draws the coach on the student's pictures, and this "
                    "is a motion without any");
  Result<std::unique_ptr<Transferer>> transferer = make_transferer(kDefaultTransferMethod);
  if (!transferer) return tl::unexpected(transferer.error());
  const Student filmed{student_from_film(student.source, student.student->track, student.student->lifted),
                       student.student->lifted};
  const bool moves = is_film(coach);
  const Result<PoseTrack> still = moves ? coach : still_film(coach);
  if (!still) return tl::unexpected(still.error());
  const Result<LiftedStudent> lifted = lift(*still);
  if (!lifted) return tl::unexpected(lifted.error());
  Result<AnalyzedPair> pair = moves ? analyze_film(*lifted, coach.source, filmed, options, **transferer)
                                    : analyze_still(*lifted, coach.source, filmed, **transferer);
  if (!pair) return pair;
  pair->analysis.retarget_method = kTransfer2d;
  pair->analysis.coach.joints = static_cast<int>(kLandmarkCount);
  return pair;
}

}  // namespace posecoach
