#include "app/library/stored_swing.h"

#include <algorithm>
#include <cmath>

#include "app/analyze/picture_retarget.h"
#include "app/film_pictures.h"
#include "core/base/log.h"
#include "core/body/body_file.h"
#include "core/body/landmark_body.h"
#include "core/image/image_codec.h"
#include "core/motion/motion_file.h"
#include "core/motion/pose_file.h"
#include "core/session/places.h"
#include "core/session/references.h"
#include "ui/report/stills.h"
#include "ui/review/film_zoom.h"
#include "ui/review/find_golfer.h"

namespace posecoach {
namespace fs = std::filesystem;
namespace {

constexpr int kThumbnailWidth_px = 320;

Result<std::optional<Skeleton>> kept_body(const Swing& swing) {
  const auto file = swing.file("student.body");
  if (!file) return std::optional<Skeleton>();
  Result<Skeleton> body = read_body_file(*file);
  if (!body) return tl::unexpected(body.error());
  return std::optional<Skeleton>(*std::move(body));
}

Result<LoadedMotion> student_from_track(PoseTrack track, std::string source, const LiftOptions& options) {
  Result<LiftedStudent> lifted = lift(track, options);
  if (!lifted) return tl::unexpected(lifted.error());
  Motion motion = lifted->motion;
  const int first_frame = lifted->first_frame;
  return LoadedMotion{std::move(source),
                      std::move(motion),
                      {},
                      SeenStudent{std::move(track), *std::move(lifted)},
                      first_frame};
}

Result<CoachInput> coach_of(const Swing& swing, const std::string& wanted, const LoadOptions& options) {
  const std::string source = wanted.empty() ? swing.facts.coach : wanted;
  const auto kept = wanted.empty() ? swing.file("coach") : std::nullopt;
  if (source.empty() && !kept)
    return fail(ErrorCode::Incomplete,
                swing.id + ": it has not been compared with a coach yet; name one with --coach");
  Result<LoadedMotion> coach =
      source.empty() ? Result<LoadedMotion>(fail(ErrorCode::NotFound, "")) : load_motion(source, options);
  if (coach) return CoachInput{source, std::move(coach->motion)};
  if (!kept) return tl::unexpected(coach.error());
  log::info(swing.id + ": the coach " + source + " is gone; his motion as it was kept counts");
  Result<MotionFile> motion = read_motion_file(*kept);
  if (!motion) return tl::unexpected(motion.error());
  return CoachInput{source, std::move(motion->motion)};
}

// As it was compared live. Without film or poses of the student, his coach's motion in space counts.
bool is_picture_reference(const std::string& source) {
  if (!source.starts_with(kReferencePrefix)) return false;
  const Result<Reference> reference = References(find_places().references()).find(source);
  return reference && reference->is_pictures;
}

Result<StoredAnswer> analyze_with_pictures(const Swing& swing, const std::string& source, const Marks& marks,
                                           LoadedMotion student) {
  const Result<PoseTrack> pictures = load_coach_pictures(source, {});
  if (!pictures) return tl::unexpected(pictures.error());
  AnalyzeOptions options;
  options.hand = swing.facts.hand;
  options.moved_events = marks.events;
  Result<AnalyzedPair> pair = analyze_in_picture(*pictures, student, options);
  if (!pair) return tl::unexpected(pair.error());
  Skeleton body = student.student->lifted.body;
  return StoredAnswer{std::move(student), *std::move(pair), std::move(body)};
}

// The golfer as large as he fits, in the usual shape.
Image around_golfer(const Image& picture, const AnalyzedSwing& swing) {
  const auto golfer = find_golfer(swing);
  if (!golfer) return picture;
  const Rect whole{0, 0, static_cast<double>(picture.width), static_cast<double>(picture.height)};
  constexpr double kShape = 16.0 / 9;
  const Rect area{0, 0, kShape * 720, 720};
  const SeenFilm seen =
      seen_film(place_film(area, whole.width, whole.height,
                           zoom_on(golfer->first, golfer->second, area, whole.width, whole.height)));
  const auto left = static_cast<int>(std::lround(seen.part.begin.x * picture.width)),
             top = static_cast<int>(std::lround(seen.part.begin.y * picture.height));
  const int width = static_cast<int>(std::lround(seen.part.size().x * picture.width)),
            height = static_cast<int>(std::lround(seen.part.size().y * picture.height));
  if (width < 16 || height < 16) return picture;
  return cut_out(picture,
                 {left, top, std::min(width, picture.width - left), std::min(height, picture.height - top)});
}

// The middle where there is no top.
std::size_t top_picture(const AnalyzedSwing& swing) {
  for (const SwingEvent& event : swing.pair.analysis.student_events)
    if (event.name == "top") return static_cast<std::size_t>(std::max(0, event.frame));
  return swing.track.frames.size() / 2;
}

Result<void> add_top(SwingDraft& draft, const AnalyzedSwing& swing) {
  const std::size_t pictures = swing.pictures ? swing.pictures->count() : 0;
  if (pictures == 0) return {};
  const Result<std::shared_ptr<const Image>> picture =
      swing.pictures->picture(std::min(top_picture(swing), pictures - 1));
  if (!picture) return tl::unexpected(picture.error());
  return add_picture(draft, around_golfer(**picture, swing));
}

Result<void> add_parts(SwingDraft& draft, const PoseTrack* track, const Motion& student, const Skeleton& body,
                       const AnalyzedPair& pair) {
  // Without a track the motion itself was imported and is there already, in its own format.
  if (track != nullptr) {
    if (const Result<void> added = draft.add_track(*track); !added) return added;
    if (const Result<void> added = draft.add_student(student, pair.analysis.student.source); !added)
      return added;
  }
  if (const Result<void> added = draft.add_body(body); !added) return added;
  if (const Result<void> added = draft.add_coach(pair.coach, pair.analysis.coach.source); !added)
    return added;
  return draft.add_analysis(pair.analysis);
}

}  // namespace

Result<LoadedMotion> load_student(const Swing& swing, const LoadOptions& options) {
  const auto film = swing.file("film"), track_file = swing.file("pose"), motion_file = swing.file("student");
  const Result<std::optional<Skeleton>> body = kept_body(swing);
  if (!body) return tl::unexpected(body.error());
  LoadOptions with_body = options;
  if (*body && is_landmark_body(**body)) with_body.lift.body = *body;
  if (track_file) {
    Result<PoseTrack> track = read_pose_track(*track_file);
    if (!track) return tl::unexpected(track.error());
    return student_from_track(*std::move(track), film.value_or(*track_file).string(), with_body.lift);
  }
  if (!film && !motion_file)
    return fail(ErrorCode::Incomplete, swing.id + ": it has neither a film nor a motion");
  return load_motion((film ? *film : *motion_file).string(), with_body);
}

Result<StoredAnswer> analyze_stored(const Swing& swing, const std::string& coach,
                                    const LoadOptions& options) {
  const Result<Marks> marks = read_marks(swing);
  // Without them the swing is still there.
  if (!marks) log::warning(marks.error().message + "; what was marked by hand is left out");
  return analyze_marked(swing, coach, marks.value_or(Marks()), options);
}

Result<StoredAnswer> analyze_marked(const Swing& swing, const std::string& coach, const Marks& marks,
                                    const LoadOptions& options) {
  Result<LoadedMotion> student = load_student(swing, options);
  if (!student) return tl::unexpected(student.error());
  const std::string& source = coach.empty() ? swing.facts.coach : coach;
  if (student->student && is_picture_reference(source))
    return analyze_with_pictures(swing, source, marks, *student);
  Result<CoachInput> coach_input = coach_of(swing, coach, options);
  if (!coach_input) return tl::unexpected(coach_input.error());
  StudentInput input =
      student->student ? student_from_film(student->source, student->student->track, student->student->lifted)
                       : student_from_motion(student->source, student->motion);
  const Result<std::optional<Skeleton>> body = kept_body(swing);
  if (body && *body) input.body = **body;
  AnalyzeOptions analyze_options;
  analyze_options.hand = swing.facts.hand;
  analyze_options.moved_events = marks.events;
  Result<AnalyzedPair> pair = analyze(input, *coach_input, analyze_options);
  if (!pair) return tl::unexpected(pair.error());
  return StoredAnswer{*std::move(student), *std::move(pair), std::move(input.body)};
}

Result<AnalyzedSwing> load_analyzed_swing(const Swing& swing, const std::string& coach,
                                          const LoadOptions& options) {
  const auto film = swing.file("film");
  if (!film) return fail(ErrorCode::Incomplete, swing.id + ": it has no film to look at");
  Result<StoredAnswer> answer = analyze_stored(swing, coach, options);
  if (!answer) return tl::unexpected(answer.error());
  SeenStudent& seen = *answer->student.student;
  std::vector<MediaTime> times;
  for (const PoseObservation& frame : seen.track.frames) times.push_back(frame.time);
  Result<std::shared_ptr<PictureStore>> pictures = open_film_pictures(*film, std::move(times));
  if (!pictures) return tl::unexpected(pictures.error());
  return AnalyzedSwing{std::move(seen.track), std::move(seen.lifted), std::move(answer->pair),
                       *std::move(pictures)};
}

Result<void> add_answer(SwingDraft& draft, const StoredAnswer& answer) {
  const SeenStudent* seen = answer.student.student ? &*answer.student.student : nullptr;
  if (seen != nullptr) draft.facts().view = to_string(seen->lifted.view);
  return add_parts(draft, seen != nullptr ? &seen->track : nullptr, answer.student.motion, answer.body,
                   answer.pair);
}

Result<void> add_answer(SwingDraft& draft, const AnalyzedSwing& swing) {
  draft.facts().view = to_string(swing.student.view);
  if (const Result<void> added =
          add_parts(draft, &swing.track, swing.student.motion, swing.student.body, swing.pair);
      !added)
    return added;
  return add_top(draft, swing);
}

Result<void> add_top_picture(SwingDraft& draft, const StoredAnswer& answer, const fs::path& film) {
  if (!answer.student.student) return {};
  const SeenStudent& seen = *answer.student.student;
  std::vector<MediaTime> times;
  for (const PoseObservation& frame : seen.track.frames) times.push_back(frame.time);
  Result<std::shared_ptr<PictureStore>> pictures = open_film_pictures(film, std::move(times));
  if (!pictures) return tl::unexpected(pictures.error());
  return add_top(draft, {seen.track, seen.lifted, answer.pair, *std::move(pictures)});
}

Result<void> add_picture(SwingDraft& draft, const Image& picture) {
  const double scale = std::min(1.0, static_cast<double>(kThumbnailWidth_px) / picture.width);
  const int height = std::max(1, static_cast<int>(std::lround(scale * picture.height)));
  const int width = std::max(1, static_cast<int>(std::lround(scale * picture.width)));
  return draft.add_thumbnail(encode_jpeg(resized(picture, width, height)));
}

}  // namespace posecoach
