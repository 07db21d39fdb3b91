#include "app/library/import_swing.h"

#include <algorithm>
#include <array>

#include "app/library/stored_swing.h"
#include "capture/video_file.h"
#include "core/base/log.h"
#include "core/motion/motion_file.h"
#include "core/motion/pose_file.h"
#include "core/session/swing_folders.h"

namespace posecoach {
namespace fs = std::filesystem;
namespace {

constexpr std::array<std::string_view, 9> kFilmEndings = {".mkv", ".mp4",  ".mov", ".avi", ".webm",
                                                          ".m4v", ".mpeg", ".mts", ".ogv"};

WallTime date_of(const fs::path& file) {
  std::error_code failed;
  const auto changed = fs::last_write_time(file, failed);
  if (failed) return wall_time_now();
  return wall_time_at(
      std::chrono::floor<std::chrono::milliseconds>(std::chrono::file_clock::to_sys(changed)));
}

std::string small_extension(const fs::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

Result<SwingDraft> begin(Library& library, const fs::path& input, const ImportOptions& options) {
  SwingFacts facts;
  facts.recorded_at = date_of(input);
  facts.person = options.person;
  facts.notes = options.notes;
  facts.hand = options.hand;
  facts.source = input.filename().string();
  return library.begin(facts);
}

Result<void> take_film(SwingDraft& draft, const fs::path& film, const ImportOptions& options) {
  // Before it is copied: that it is a film at all.
  Result<std::unique_ptr<FrameSource>> source = open_video_file(film);
  if (!source) return tl::unexpected(source.error());
  const Result<std::optional<Frame>> frame = (*source)->next({});
  if (!frame) return tl::unexpected(frame.error());
  if (!*frame) return fail(ErrorCode::Incomplete, film.string() + ": no pictures in it");
  const std::string extension = small_extension(film);
  const bool is_known = std::find(kFilmEndings.begin(), kFilmEndings.end(), extension) != kFilmEndings.end();
  const std::string name = "film" + (is_known ? extension : ".video");
  if (const Result<void> copied = draft.add_copy(name, film, options.load.progress); !copied) return copied;
  return add_picture(draft, *(*frame)->image);
}

Result<void> take_motion(SwingDraft& draft, const fs::path& file, MotionFormat format,
                         const ImportOptions& options) {
  if (format == MotionFormat::PoseTrack) {
    const Result<PoseTrack> track = read_pose_track(file);
    if (!track) return tl::unexpected(track.error());
    draft.facts().frames = static_cast<int>(track->frames.size());
    if (!track->frames.empty())
      draft.facts().seconds = to_seconds(track->frames.back().time - track->frames.front().time);
    return draft.add_copy("pose.pose.json", file, options.load.progress);
  }
  const Result<MotionFile> motion = read_motion_file(file);
  if (!motion) return tl::unexpected(motion.error());
  draft.facts().frames = motion->motion.frame_count();
  draft.facts().seconds = to_seconds(motion->motion.duration());
  switch (format) {
    case MotionFormat::Bvh:
      return draft.add_copy("student.bvh", file);
    case MotionFormat::Trc:
      return draft.add_copy("student.trc", file);
    case MotionFormat::C3d:
      return draft.add_copy("student.c3d", file);
    default:
      // An AMC is nothing without its ASF.
      return draft.add_student(motion->motion, file.filename().string());
  }
}

Result<void> take(SwingDraft& draft, const fs::path& input, const ImportOptions& options) {
  const Result<MotionFormat> format = motion_format(input);
  if (!format && format.error().code == ErrorCode::Unsupported) return take_film(draft, input, options);
  if (!format) return tl::unexpected(format.error());
  if (*format == MotionFormat::BodyFile)
    return fail(ErrorCode::Unsupported, input.string() + ": this is a body; a swing is a film or a motion");
  return take_motion(draft, input, *format, options);
}

Result<void> import_file(Library& library, const fs::path& input, const ImportOptions& options,
                         Imported& imported) {
  Result<SwingDraft> draft = begin(library, input, options);
  if (!draft) return tl::unexpected(draft.error());
  if (const Result<void> taken = take(*draft, input, options); !taken) return taken;
  Result<Swing> swing = library.keep(*std::move(draft), options.load.progress);
  if (!swing) return tl::unexpected(swing.error());
  if (!options.coach.empty()) {
    // It is kept whatever comes out of comparing it.
    Result<StoredAnswer> answer = analyze_stored(*swing, options.coach, options.load);
    if (!answer && answer.error().code == ErrorCode::Cancelled) {
      // Who stops an import wants nothing of it.
      Result<Swing> trashed = library.trash(swing->id);
      const Result<void> gone = trashed ? library.purge(swing->id) : tl::unexpected(trashed.error());
      if (!gone) return gone;
      return tl::unexpected(answer.error());
    }
    Result<SwingDraft> again =
        answer ? library.begin_again(swing->id) : Result<SwingDraft>(tl::unexpected(answer.error()));
    Result<void> added = again ? add_answer(*again, *answer) : Result<void>(tl::unexpected(again.error()));
    if (const auto film = swing->file("film"); film && added)
      if (const Result<void> pictured = add_top_picture(*again, *answer, *film); !pictured)
        log::warning(pictured.error().message);
    Result<Swing> analyzed =
        added ? library.keep(*std::move(again)) : Result<Swing>(tl::unexpected(added.error()));
    if (analyzed)
      swing = std::move(analyzed);
    else
      imported.remarks.push_back(swing->id + " is kept, but not compared: " + analyzed.error().message);
  }
  imported.swings.push_back(*std::move(swing));
  return {};
}

// The same files under the same name: it came from here, or was imported before.
bool is_here(Library& library, const Swing& swing) {
  const Result<Swing> own = library.find(swing.id);
  if (!own || own->files.size() != swing.files.size()) return false;
  return std::equal(
      own->files.begin(), own->files.end(), swing.files.begin(),
      [](const auto& a, const auto& b) { return a.first == b.first && a.second.sha256 == b.second.sha256; });
}

Result<void> import_swing(Library& library, const fs::path& folder, const ImportOptions& options,
                          Imported& imported) {
  const Result<Swing> swing = read_swing(folder);
  if (!swing) return tl::unexpected(swing.error());
  if (is_here(library, *swing)) {
    imported.remarks.push_back(swing->id + " is here already");
    return {};
  }
  Result<SwingDraft> draft = library.begin(swing->facts);
  if (!draft) return tl::unexpected(draft.error());
  for (const auto& [name, stored] : swing->files)
    if (const Result<void> copied = draft->add_copy(name, folder / name, options.load.progress); !copied)
      return copied;
  // With what a later version wrote into it.
  if (const Result<void> copied = draft->add_copy(kSwingFile, folder / kSwingFile); !copied) return copied;
  Result<Swing> kept = library.keep(*std::move(draft), options.load.progress);
  if (!kept) return tl::unexpected(kept.error());
  imported.swings.push_back(*std::move(kept));
  return {};
}

Result<void> import_folder(Library& library, const fs::path& folder, const ImportOptions& options,
                           Imported& imported) {
  const Result<std::vector<FoundSwing>> swings = find_swings(folder);
  if (!swings) return tl::unexpected(swings.error());
  std::size_t found = 0;
  for (const FoundSwing& swing : *swings) {
    if (swing.shelf == Shelf::Trash) continue;
    ++found;
    const Result<void> done = import_swing(library, folder / swing.id, options, imported);
    if (!done && done.error().code == ErrorCode::Cancelled) return done;
    if (!done) imported.remarks.push_back(swing.id + " was not imported: " + done.error().message);
  }
  std::vector<fs::path> films;
  std::error_code failed;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed))
    if (std::find(kFilmEndings.begin(), kFilmEndings.end(), small_extension(entry->path())) !=
        kFilmEndings.end())
      films.push_back(entry->path());
  std::sort(films.begin(), films.end());
  for (const fs::path& film : films)
    if (const Result<void> done = import_file(library, film, options, imported); !done) return done;
  if (found + films.size() == 0)
    return fail(ErrorCode::NotFound, folder.string() + ": neither swings nor films are in this folder");
  return {};
}

}  // namespace

Result<Imported> import_swings(Library& library, const fs::path& input, const ImportOptions& options) {
  Imported imported;
  std::error_code failed;
  const bool is_folder = fs::is_directory(input, failed);
  const bool is_swing = is_folder && fs::exists(input / kSwingFile, failed);
  const Result<void> done = is_swing    ? import_swing(library, input, options, imported)
                            : is_folder ? import_folder(library, input, options, imported)
                                        : import_file(library, input, options, imported);
  if (!done) return tl::unexpected(done.error());
  return imported;
}

}  // namespace posecoach
