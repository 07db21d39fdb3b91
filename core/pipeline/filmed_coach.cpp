#include "core/pipeline/filmed_coach.h"

#include <algorithm>

#include "core/body/landmark_body.h"
#include "core/coaching/text/picture_text.h"
#include "core/pipeline/analyze_picture.h"
#include "core/pipeline/picture_coach.h"

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

// With hands above the hips he is in the middle of a stroke, and turned: from where the camera sees his
// address, such a picture does not tell.
bool shows_side(const LiftedStudent& still) {
  const auto height = [&](HumanoidJoint role) { return still.motion.position(0, still.body.find(role)).y; };
  using enum HumanoidJoint;
  return std::max(height(LeftWrist), height(RightWrist)) < std::max(height(LeftHip), height(RightHip));
}

Result<AnalyzedPair> analyze_film(const FilmedCoach& coach, const StudentInput& input,
                                  const LiftedStudent& student, const AnalyzeOptions& options,
                                  Transferer& transferer) {
  // The two must show the same side of a swing, so the coach's film is mirrored, not his motion.
  const Handedness hand = options.hand.value_or(hand_of(input.motion, input.sight)),
                   his = hand_of(coach.lifted.motion);
  const Result<PictureCoach> carried =
      coach_in_picture(hand == his ? coach.lifted : mirrored(coach.lifted), student, transferer);
  if (!carried) return tl::unexpected(carried.error());
  Result<AnalyzedPair> pair = analyze(input, {coach.source, carried->motion}, options);
  if (!pair) return pair;
  pair->analysis.contacts = false;
  pair->analysis.notes.insert(pair->analysis.notes.end(), carried->doubts.begin(), carried->doubts.end());
  return pair;
}

Result<AnalyzedPair> analyze_still(const FilmedCoach& coach, const StudentInput& input,
                                   const LiftedStudent& student, Transferer& transferer) {
  std::optional<AnalyzedPair> best;
  std::string reason;
  ErrorCode code = ErrorCode::Incomplete;
  // Nobody knows from a picture which hand the coach plays with.
  for (const bool is_mirrored : {false, true}) {
    const Result<PictureCoach> carried =
        coach_in_picture(is_mirrored ? mirrored(coach.lifted) : coach.lifted, student, transferer);
    if (!carried) return tl::unexpected(carried.error());
    Result<AnalyzedPair> pair = analyze_picture(input, {coach.source, carried->motion});
    if (!pair) {
      code = pair.error().code;
      reason = pair.error().message;
      continue;
    }
    if (best &&
        pair->analysis.score.mean_joint_error_m > kClearlyBetter * best->analysis.score.mean_joint_error_m)
      continue;
    std::vector<std::string>& notes = pair->analysis.notes;
    if (is_mirrored) notes.push_back(text::picture_is_mirrored());
    notes.insert(notes.end(), carried->doubts.begin(), carried->doubts.end());
    best = *std::move(pair);
  }
  if (!best) return fail(code, reason);
  return *std::move(best);
}

// Short enough to be read on the live picture.
std::optional<std::string> words_about(const std::vector<Joint2d>& hidden) {
  constexpr std::size_t kMostNamed = 3;
  std::string list;
  std::size_t count = 0;
  for (const Joint2d joint : hidden) {
    // What hangs between two others is not missed by itself.
    if (joint == Joint2d::Neck || joint == Joint2d::MidHip || ++count > kMostNamed) continue;
    std::string name(to_string(joint));
    std::replace(name.begin(), name.end(), '_', ' ');
    list += (list.empty() ? "" : ", ") + name;
  }
  if (list.empty()) return std::nullopt;
  if (count > kMostNamed) list += " and " + std::to_string(count - kMostNamed) + " more";
  return text::left_out_where_hidden(list);
}

}  // namespace

Result<FilmedCoach> filmed_coach_from(const PoseTrack& pictures,
                                      std::function<Result<std::unique_ptr<Transferer>>()> make_transferer) {
  const bool is_still = !is_film(pictures);
  const Result<PoseTrack> track = is_still ? still_film(pictures) : pictures;
  if (!track) return tl::unexpected(track.error());
  Result<LiftedStudent> lifted = lift(*track);
  if (!lifted) return tl::unexpected(lifted.error());
  if (is_still && !shows_side(*lifted)) lifted->view = View::Between;
  return FilmedCoach{pictures.source, *std::move(lifted), is_still, std::move(make_transferer)};
}

Result<PersonalCoach> make_personal_coach(const FilmedCoach& coach, const Skeleton& body, Handedness hand) {
  const Result<std::unique_ptr<Transferer>> transferer = coach.make_transferer();
  if (!transferer) return tl::unexpected(transferer.error());
  // A picture does not tell the hand; most coaches play right-handed.
  const Handedness his = coach.is_still ? Handedness::Right : hand_of(coach.lifted.motion);
  const bool is_mirrored = hand != his;
  Result<PictureCoach> carried =
      coach_on_body(is_mirrored ? mirrored(coach.lifted) : coach.lifted, body, **transferer);
  if (!carried) return tl::unexpected(carried.error());
  Result<PersonalCoach> made = personal_coach_from(std::move(carried->motion));
  if (!made) return made;
  made->is_flat = true;
  if (is_mirrored && coach.is_still) made->message = text::picture_is_mirrored_for_left_handed() + " ";
  made->message += words_about(carried->hidden).value_or("");
  return made;
}

std::optional<std::string> wrong_side(const FilmedCoach& coach, View student) {
  const View his = coach.lifted.view;
  if (his == View::Between || student == View::Between || his == student) return std::nullopt;
  return text::coach_is_seen_from(to_string(his));
}

Result<AnalyzedPair> analyze_in_picture(const FilmedCoach& coach, const StudentInput& input,
                                        const LiftedStudent& student, const AnalyzeOptions& options) {
  const Result<std::unique_ptr<Transferer>> transferer = coach.make_transferer();
  if (!transferer) return tl::unexpected(transferer.error());
  Result<AnalyzedPair> pair = coach.is_still ? analyze_still(coach, input, student, **transferer)
                                             : analyze_film(coach, input, student, options, **transferer);
  if (!pair) return pair;
  pair->analysis.retarget_method = kTransfer2d;
  pair->analysis.coach.joints = static_cast<int>(kLandmarkCount);
  return pair;
}

}  // namespace posecoach
