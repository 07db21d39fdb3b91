#include <algorithm>
#include <map>

#include "app/library/export_swing.h"
#include "app/library/import_swing.h"
#include "app/library/stored_swing.h"
#include "app/window/window_program.h"
#include "core/base/log.h"
#include "core/image/image_codec.h"
#include "core/session/disk.h"
#include "core/session/wall_time.h"
#include "ui/render/words.h"

namespace posecoach {
namespace {

std::string coach_words(const std::vector<CoachChoice>& coaches, const std::string& source) {
  for (const CoachChoice& coach : coaches)
    if (coach.id == source) return coach.title;
  return source;
}

// "today 14:32", "yesterday 18:05", "2026-05-12 18:05".
std::string when_words(const WallTime& time) {
  const std::string words = to_words(time), clock = words.substr(words.find(' '));
  const WallTime now = wall_time_now();
  if (day_of(time) == day_of(now)) return "today" + clock;
  if (day_of(time) == day_of(wall_time_at(now.utc - std::chrono::hours(24)))) return "yesterday" + clock;
  return words;
}

using Thumbnails = std::map<std::string, std::shared_ptr<const Image>>;  // by their files' digests

// Read once: a swing that is analysed anew gets another.
std::shared_ptr<const Image> thumbnail_of(const Swing& swing, const Thumbnails& known, Thumbnails& used) {
  const auto file = swing.file("thumb");
  if (!file) return nullptr;
  const std::string& digest = swing.files.at(file->filename().string()).sha256;
  if (const auto found = known.find(digest); found != known.end()) return used[digest] = found->second;
  Result<Image> read = read_image(*file);
  if (!read) return nullptr;
  return used[digest] = std::make_shared<const Image>(*std::move(read));
}

SwingCard make_card(const Swing& swing, const std::vector<CoachChoice>& coaches) {
  SwingCard card;
  card.id = swing.id;
  card.is_trashed = swing.shelf == Shelf::Trash;
  card.unreadable = swing.unreadable;
  card.title = swing.is_readable()
                   ? title_from_name(swing.facts.stroke.empty() ? "swing" : swing.facts.stroke)
                   : swing.id;
  if (swing.is_readable()) {
    card.date = to_words(swing.facts.recorded_at);
    card.when = when_words(swing.facts.recorded_at);
  }
  card.person = swing.facts.person;
  card.coach = coach_words(coaches, swing.facts.coach);
  card.stroke = swing.facts.stroke;
  card.notes = swing.facts.notes;
  card.score_percent = swing.facts.score_percent;
  card.seconds = swing.facts.seconds;
  card.is_starred = swing.facts.star;
  return card;
}

std::string_view ending_of(ExportKind kind) {
  switch (kind) {
    case ExportKind::OverlayFilm:
      return ".overlay.mp4";
    case ExportKind::DrawnFilm:
      return ".drawn.overlay.mp4";
    case ExportKind::Report:
      return ".html";
    case ExportKind::Csv:
      return ".csv";
    case ExportKind::Bvh:
      return ".bvh";
    case ExportKind::Trc:
      break;
  }
  return ".trc";
}

// What the pose stage saw and what was answered, so that the next time is quick.
Result<void> keep_answer(Library& library, const Swing& swing, const AnalyzedSwing& answer) {
  Result<SwingDraft> draft = library.begin_again(swing.id);
  if (!draft) return tl::unexpected(draft.error());
  if (const Result<void> added = add_answer(*draft, answer); !added) return added;
  const Result<Swing> kept = library.keep(*std::move(draft));
  if (!kept) return tl::unexpected(kept.error());
  return {};
}

}  // namespace

void WindowProgram::refresh_swings() {
  if (!library_) return;
  keeping_->start(
      "Listing the swings",
      [this, known = thumbnails_, coaches = model_.coaches](const Progress&) -> Result<JobQueue::Finish> {
        Thumbnails used;
        std::vector<SwingCard> cards;
        for (const Shelf shelf : {Shelf::Kept, Shelf::Trash}) {
          SwingQuery query;
          query.shelf = shelf;
          const Result<std::vector<Swing>> swings = library_->list(query);
          if (!swings)
            return JobQueue::Finish(
                [this, message = swings.error().message] { model_.library_message = message; });
          for (const Swing& swing : *swings) {
            cards.push_back(make_card(swing, coaches));
            cards.back().thumbnail = thumbnail_of(swing, known, used);
          }
        }
        return JobQueue::Finish([this, used, cards = std::move(cards)] {
          model_.swings = cards;
          thumbnails_ = used;
        });
      },
      false);
}

void WindowProgram::change_card(const std::string& id, const std::function<void(SwingCard&)>& change) {
  for (SwingCard& card : model_.swings)
    if (card.id == id) change(card);
}

OpenedSwing WindowProgram::make_opened(const std::string& id, std::string title,
                                       std::shared_ptr<const AnalyzedSwing> swing, bool is_starred,
                                       Reading reading) {
  OpenedSwing opened;
  opened.id = id;
  opened.title = std::move(title);
  opened.detail = "against " + coach_words(model_.coaches, swing->pair.analysis.coach.source);
  opened.review = make_review_swing(swing);
  opened.picture = lookup_of(std::make_shared<PictureFetcher>(swing->pictures, reading));
  opened.is_starred = is_starred;
  return opened;
}

void WindowProgram::open_swing(const std::string& id, bool as_second, WindowState& state) {
  if (!library_) return;
  state.is_picking_second = false;
  const Result<Swing> swing = library_->find(id);
  if (!swing) return tell(ToastKind::Warning, swing.error().message);
  // One that was only recorded is compared with the coach of now.
  const bool has_coach = !swing->facts.coach.empty() || swing->file("coach").has_value();
  const std::string coach = has_coach ? std::string() : model_.coach;
  jobs_->start(
      "Opening the swing",
      [this, swing = *swing, as_second, coach](const Progress& progress) -> Result<JobQueue::Finish> {
        Result<AnalyzedSwing> loaded = load_analyzed_swing(swing, coach, {pose_, {}, progress});
        if (!loaded) return tl::unexpected(loaded.error());
        const bool is_new = !swing.file("pose");
        if (is_new)
          if (const Result<void> kept = keep_answer(*library_, swing, *loaded); !kept)
            log::warning(kept.error().message);
        loaded->pictures = make_shared_store(std::move(loaded->pictures));
        const auto opened = std::make_shared<const AnalyzedSwing>(*std::move(loaded));
        const Marks marks = read_marks(swing).value_or(Marks());
        return JobQueue::Finish([this, opened, swing, as_second, marks, is_new] {
          if (is_new) refresh_swings();
          const std::string title =
              title_from_name(swing.facts.stroke.empty() ? "swing" : swing.facts.stroke) + ", " +
              when_words(swing.facts.recorded_at);
          OpenedSwing made = make_opened(swing.id, title, opened, swing.facts.star, Reading::Ahead);
          made.marks = marks;
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
  change_card(id, [](SwingCard& card) { card.is_trashed = true; });
  tell(ToastKind::Information, "The swing is in the trash.", "Undo", intent::RestoreSwing{id});
}

void WindowProgram::refresh_coaches() {
  model_.coaches.clear();
  for (const Reference& reference : references_.list()) {
    if (!reference.unreadable.empty()) continue;
    model_.coaches.push_back({reference.source, reference.name,
                              reference.is_bundled() ? "Comes with the program"
                              : reference.origin.find("swing_") != std::string::npos
                                  ? "A recorded swing"
                                  : "From " + reference.origin});
  }
}

void WindowProgram::make_reference(const std::string& id) {
  if (!library_) return;
  const Result<Swing> swing = library_->find(id);
  if (!swing) return tell(ToastKind::Warning, swing.error().message);
  const Result<Reference> reference = references_.add_swing(*swing);
  if (!reference) return tell(ToastKind::Warning, reference.error().message);
  refresh_coaches();
  const std::string before = model_.coach;
  choose_coach(reference->source);
  tell(ToastKind::Good, "Later swings are compared with " + reference->name + ".", "Undo",
       intent::ChooseCoach{before});
}

void WindowProgram::import_file(const std::string& path, WindowState& state) {
  if (!library_) return;
  state.screen = ScreenName::Library;
  ImportOptions options;
  options.person = person_.name;
  options.coach = model_.coach;
  options.hand = person_.hand;
  options.load.pose = pose_;
  jobs_->start("Importing " + std::filesystem::path(path).filename().string(),
               [this, path, options](const Progress& progress) -> Result<JobQueue::Finish> {
                 ImportOptions here = options;
                 here.load.progress = progress;
                 const Result<Imported> imported = import_swings(*library_, path, here);
                 if (!imported)
                   return JobQueue::Finish([this, error = imported.error()] {
                     refresh_swings();  // it may have been listed while it was there
                     if (error.code == ErrorCode::Cancelled)
                       tell(ToastKind::Information, "Stopped; nothing of it is in the library.");
                     else
                       tell(ToastKind::Warning, error.message);
                   });
                 return JobQueue::Finish([this, imported = *imported] {
                   refresh_swings();
                   for (const std::string& remark : imported.remarks) tell(ToastKind::Warning, remark);
                   if (imported.swings.size() == 1)
                     tell(ToastKind::Good, "It is in the library.", "Review",
                          intent::OpenSwing{imported.swings.front().id});
                   else
                     tell(ToastKind::Good,
                          std::to_string(imported.swings.size()) + " swings are in the library.");
                 });
               });
}

void WindowProgram::export_swing(const std::string& id, ExportKind kind) {
  if (!library_) return;
  const Result<Swing> swing = library_->find(id);
  if (!swing)
    return tell(ToastKind::Warning, id.empty() ? "The swing is still being kept." : swing.error().message);
  jobs_->start("Exporting",
               [this, swing = *swing, kind, palette = model_.palette,
                library = library_.get()](const Progress& progress) -> Result<JobQueue::Finish> {
                 const std::filesystem::path folder = places_.library / "Exports";
                 if (const Result<void> made = make_folders(system_disk(), folder); !made)
                   return tl::unexpected(made.error());
                 const std::filesystem::path file =
                     folder / (swing.folder.filename().string() + std::string(ending_of(kind)));
                 const bool has_drawings = kind == ExportKind::DrawnFilm;
                 const ExportOptions options{{}, {pose_, {}, progress}, palette, library, has_drawings};
                 if (const Result<void> written = posecoach::export_swing(swing, file, options); !written)
                   return tl::unexpected(written.error());
                 return JobQueue::Finish([this, file] {
                   tell(ToastKind::Good, "Exported: " + file.filename().string(), "Show",
                        intent::ShowFolder{file.parent_path().string()});
                 });
               });
}

}  // namespace posecoach
