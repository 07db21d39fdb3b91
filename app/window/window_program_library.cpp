#include <algorithm>

#include "app/analyze_outputs.h"
#include "app/load_motion.h"
#include "app/window/live_session.h"
#include "app/window/window_program.h"
#include "core/base/file.h"
#include "core/image/image_codec.h"
#include "core/motion/motion_file.h"
#include "core/motion/pose_file.h"
#include "core/session/motion_table.h"
#include "core/session/wall_time.h"
#include "ui/render/words.h"

namespace posecoach {
namespace {

std::string coach_words(const WindowModel& model, const std::string& source) {
  for (const CoachChoice& coach : model.coaches)
    if (coach.id == source) return coach.title;
  return source;
}

std::string file_safe(std::string name) {
  for (char& c : name)
    if (c == '/' || c == ' ') c = '_';
  return name;
}

// What a kept swing is made of, worked out anew from what the pose stage saw: the same every time.
struct Rebuilt {
  std::string film;
  PoseTrack track;
  LiftedStudent lifted;
  AnalyzedPair pair;
};

Result<Motion> coach_of(const Swing& swing, const References& references) {
  Result<Motion> motion = load_reference(references, swing.facts.coach);
  if (motion) return motion;
  // The reference is gone: the coach as he was compared then, in the student's body.
  const auto kept = swing.file("coach");
  if (!kept) return motion;
  Result<MotionFile> file = read_motion_file(*kept);
  if (!file) return tl::unexpected(file.error());
  return std::move(file->motion);
}

Result<Rebuilt> rebuild(const Swing& swing, const References& references, const Progress& progress) {
  const auto pose = swing.file("pose"), film = swing.file("film");
  if (!pose || !film)
    return fail(ErrorCode::Incomplete,
                swing.folder.string() + ": the swing has no film, so it cannot be reviewed");
  if (!report(progress, "reading", 0.1)) return fail(ErrorCode::Cancelled, "stopped");
  Result<PoseTrack> track = read_pose_track(*pose);
  if (!track) return tl::unexpected(track.error());
  LiftOptions options;
  if (const auto body = swing.file("student.body"))
    if (Result<SkeletonFile> file = read_skeleton_file(*body)) options.body = std::move(file->skeleton);
  Result<LiftedStudent> lifted = lift(*track, options);
  if (!lifted) return tl::unexpected(lifted.error());
  if (!report(progress, "comparing", 0.5)) return fail(ErrorCode::Cancelled, "stopped");
  const Result<Motion> coach = coach_of(swing, references);
  if (!coach) return tl::unexpected(coach.error());
  AnalyzeOptions analysis;
  analysis.hand = swing.facts.hand;
  Result<AnalyzedPair> pair =
      analyze(student_from_film(film->string(), *track, *lifted), {swing.facts.coach, *coach}, analysis);
  if (!pair) return tl::unexpected(pair.error());
  return Rebuilt{film->string(), *std::move(track), *std::move(lifted), *std::move(pair)};
}

}  // namespace

void WindowProgram::refresh_swings() {
  if (!library_) return;
  std::map<std::string, std::shared_ptr<const Image>> thumbnails;
  for (const SwingCard& card : model_.swings) thumbnails[card.id] = card.thumbnail;
  model_.swings.clear();
  for (const Shelf shelf : {Shelf::Kept, Shelf::Trash}) {
    SwingQuery query;
    query.shelf = shelf;
    const Result<std::vector<Swing>> swings = library_->list(query);
    if (!swings) {
      model_.library_message = swings.error().message;
      return;
    }
    for (const Swing& swing : *swings) {
      SwingCard card;
      card.id = swing.id;
      card.is_trashed = shelf == Shelf::Trash;
      card.unreadable = swing.unreadable;
      card.title = swing.is_readable()
                       ? (swing.facts.stroke.empty() ? "Swing" : title_from_name(swing.facts.stroke))
                       : swing.id;
      if (swing.is_readable()) card.when = to_words(swing.facts.recorded_at);
      card.person = swing.facts.person;
      card.coach = coach_words(model_, swing.facts.coach);
      card.stroke = swing.facts.stroke;
      card.notes = swing.facts.notes;
      card.score_percent = swing.facts.score_percent;
      card.seconds = swing.facts.seconds;
      card.is_starred = swing.facts.star;
      if (const auto known = thumbnails.find(swing.id); known != thumbnails.end() && known->second)
        card.thumbnail = known->second;
      else if (const auto file = swing.file("thumb"))
        if (Result<Image> image = read_image(*file))
          card.thumbnail = std::make_shared<const Image>(*std::move(image));
      model_.swings.push_back(std::move(card));
    }
  }
}

OpenedSwing WindowProgram::make_opened(const std::string& id, std::string title,
                                       std::shared_ptr<const AnalyzedSwing> swing, bool is_starred) {
  OpenedSwing opened;
  opened.id = id;
  opened.title = std::move(title);
  opened.detail =
      swing->pair.analysis.stroke + " · against " + coach_words(model_, swing->pair.analysis.coach.source);
  opened.review = make_review_swing(swing);
  opened.picture = lookup_of(std::make_shared<PictureFetcher>(swing->pictures));
  opened.is_starred = is_starred;
  return opened;
}

void WindowProgram::open_swing(const std::string& id, bool as_second, WindowState& state) {
  if (!library_) return;
  state.is_picking_second = false;
  const Result<Swing> swing = library_->find(id);
  if (!swing) return tell(ToastKind::Warning, swing.error().message);
  jobs_->start("Opening the swing",
               [this, swing = *swing, as_second](const Progress& progress) -> Result<JobQueue::Finish> {
                 Result<Rebuilt> rebuilt = rebuild(swing, references_, progress);
                 if (!rebuilt) return tl::unexpected(rebuilt.error());
                 Result<std::shared_ptr<PictureStore>> pictures =
                     open_film_store(rebuilt->film, rebuilt->track);
                 if (!pictures) return tl::unexpected(pictures.error());
                 auto opened = std::make_shared<const AnalyzedSwing>(
                     AnalyzedSwing{std::move(rebuilt->track), std::move(rebuilt->lifted),
                                   std::move(rebuilt->pair), make_shared_store(*std::move(pictures))});
                 return JobQueue::Finish([this, opened, swing, as_second] {
                   const std::string title =
                       title_from_name(swing.facts.stroke.empty() ? "swing" : swing.facts.stroke) + ", " +
                       to_words(swing.facts.recorded_at);
                   OpenedSwing made = make_opened(swing.id, title, opened, swing.facts.star);
                   if (as_second && model_.opened) {
                     model_.compared = std::move(made);
                   } else {
                     model_.opened = std::move(made);
                     model_.compared.reset();
                   }
                   wanted_screen_ = ScreenName::Review;
                 });
               });
}

void WindowProgram::trash_swing(const std::string& id, WindowState& state) {
  if (!library_) return;
  if (const Result<Swing> trashed = library_->trash(id); !trashed)
    return tell(ToastKind::Warning, trashed.error().message);
  if (state.selected == id) state.selected.clear();
  refresh_swings();
  tell(ToastKind::Information, "The swing is in the trash.", "Undo", intent::RestoreSwing{id});
}

void WindowProgram::refresh_coaches() {
  model_.coaches.clear();
  for (const Reference& reference : references_.list()) {
    if (!reference.unreadable.empty()) continue;
    model_.coaches.push_back(
        {reference.source, reference.name,
         reference.is_bundled() ? "Comes with the program" : "From " + reference.origin});
  }
}

void WindowProgram::make_reference(const std::string& id) {
  if (!library_) return;
  const Result<Swing> swing = library_->find(id);
  if (!swing) return tell(ToastKind::Warning, swing.error().message);
  const Result<Reference> reference = references_.add_swing(*swing);
  if (!reference) return tell(ToastKind::Warning, reference.error().message);
  refresh_coaches();
  choose_coach(reference->source);
  tell(ToastKind::Good, "Later swings are compared with " + reference->name + ".");
}

void WindowProgram::import_file(const std::string& path, WindowState& state) {
  if (!library_) return;
  state.screen = ScreenName::Library;
  SwingFacts facts;
  facts.recorded_at = wall_time_now();
  facts.person = person_.name;
  facts.coach = model_.coach;
  facts.source = path;
  facts.hand = person_.hand;
  jobs_->start("Importing " + std::filesystem::path(path).filename().string(),
               [this, path, facts, pose = pose_](const Progress& progress) -> Result<JobQueue::Finish> {
                 Result<LoadedMotion> student = load_motion(path, {pose, {}, progress});
                 if (!student) return tl::unexpected(student.error());
                 if (!student->student)
                   return fail(ErrorCode::Unsupported,
                               path + ": this is a motion; add it as a coach in Set-up");
                 const Result<Motion> coach = load_reference(references_, facts.coach);
                 if (!coach) return tl::unexpected(coach.error());
                 const SeenStudent& seen = *student->student;
                 const Result<AnalyzedPair> pair =
                     analyze(student_from_film(path, seen.track, seen.lifted), {facts.coach, *coach});
                 if (!pair) return tl::unexpected(pair.error());
                 Result<SwingDraft> draft = library_->begin(facts);
                 if (!draft) return tl::unexpected(draft.error());
                 std::string extension = std::filesystem::path(path).extension().string();
                 if (extension.empty()) extension = ".mp4";
                 for (const auto& deed : std::initializer_list<std::function<Result<void>()>>{
                          [&] { return draft->add_copy("film" + extension, path, progress); },
                          [&] { return draft->add_track(seen.track); },
                          [&] { return draft->add_student(seen.lifted.motion, path); },
                          [&] { return draft->add_body(seen.lifted.body); },
                          [&] { return draft->add_coach(pair->coach, facts.coach); },
                          [&] { return draft->add_analysis(pair->analysis); }})
                   if (const Result<void> done = deed(); !done) return tl::unexpected(done.error());
                 const Result<Swing> kept = library_->keep(*std::move(draft), progress);
                 if (!kept) return tl::unexpected(kept.error());
                 return JobQueue::Finish([this, id = kept->id] {
                   refresh_swings();
                   tell(ToastKind::Good, "The film is in the library.", "Review", intent::OpenSwing{id});
                 });
               });
}

void WindowProgram::export_swing(const std::string& id, ExportKind kind) {
  if (!library_) return;
  const Result<Swing> swing = library_->find(id);
  if (!swing)
    return tell(ToastKind::Warning, id.empty() ? "The swing is still being kept." : swing.error().message);
  const Palette palette = model_.palette;
  jobs_->start(
      "Exporting",
      [this, swing = *swing, kind, palette](const Progress& progress) -> Result<JobQueue::Finish> {
        Result<Rebuilt> rebuilt = rebuild(swing, references_, progress);
        if (!rebuilt) return tl::unexpected(rebuilt.error());
        const std::filesystem::path folder = places_.library / "Exports";
        std::error_code failed;
        std::filesystem::create_directories(folder, failed);
        if (failed)
          return fail(ErrorCode::Unreadable, folder.string() + ": cannot be made: " + failed.message());
        const std::filesystem::path base = folder / file_safe(swing.id);
        const auto named = [&](const char* extension) { return base.string() + extension; };
        const LoadedMotion student{rebuilt->film,
                                   rebuilt->lifted.motion,
                                   {},
                                   SeenStudent{rebuilt->track, rebuilt->lifted},
                                   rebuilt->lifted.first_frame};
        std::string path;
        Result<void> written;
        AnalyzeOutputs outputs;
        outputs.palette = palette;
        switch (kind) {
          case ExportKind::OverlayFilm:
            path = outputs.video = named(".mp4");
            written = write_outputs(outputs, student, rebuilt->pair, progress);
            break;
          case ExportKind::Report:
            path = outputs.report = named(".html");
            written = write_outputs(outputs, student, rebuilt->pair, progress);
            break;
          case ExportKind::Csv:
            path = named(".csv");
            written = write_file_atomically(path, csv_from_motion(student.motion, student.first_frame));
            break;
          case ExportKind::Bvh:
            path = named(".bvh");
            written = write_motion_file(path, rebuilt->pair.coach);
            break;
          case ExportKind::Trc:
            path = named(".trc");
            written = write_motion_file(path, student.motion);
            break;
        }
        if (!written) return tl::unexpected(written.error());
        return JobQueue::Finish([this, path] { tell(ToastKind::Good, "Exported: " + path); });
      });
}

}  // namespace posecoach
