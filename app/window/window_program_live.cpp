#include <cmath>

#include "app/library/stored_swing.h"
#include "app/window/memory.h"
#include "app/window/window_program.h"
#include "capture/video_writer.h"
#include "core/image/image_codec.h"
#include "core/motion/motion_file.h"
#include "core/session/wall_time.h"
#include "ui/render/words.h"

namespace posecoach {
namespace {

// As long as the pipeline shows its answer (CoachPipelineOptions).
const double kReplay_s = CoachPipelineOptions{}.replay_s;

constexpr std::string_view kCamera = "camera:";

Result<std::filesystem::path> file_for_now(const std::filesystem::path& folder, std::string_view what,
                                           std::string_view extension) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) return fail(ErrorCode::Unreadable, folder.string() + ": cannot be made: " + failed.message());
  const WallTime now = wall_time_now();
  return folder / (day_of(now) + "_" + clock_of(now) + "_" + std::string(what) + std::string(extension));
}

Result<void> write_film(const AnalyzedSwing& swing, const std::filesystem::path& path,
                        const Progress& progress) {
  const std::size_t count = swing.pictures->count();
  Result<std::shared_ptr<const Image>> first = swing.pictures->picture(0);
  if (!first) return tl::unexpected(first.error());
  Result<std::unique_ptr<VideoWriter>> opened =
      VideoWriter::open(path, {.width = (**first).width, .height = (**first).height});
  if (!opened) return tl::unexpected(opened.error());
  VideoWriter& writer = **opened;
  for (std::size_t i = 0; i < count; ++i) {
    const Result<std::shared_ptr<const Image>> picture = swing.pictures->picture(i);
    if (!picture) return tl::unexpected(picture.error());
    if (const Result<void> written = writer.write(**picture, swing.pictures->time(i)); !written)
      return written;
    if (!report(progress, "film", static_cast<double>(i) / static_cast<double>(count)))
      return fail(ErrorCode::Cancelled, "stopped while keeping the swing");
  }
  return writer.finish();
}

}  // namespace

void WindowProgram::follow_loop(const CoachSnapshot& snapshot, double time_s) {
  model_.is_simulated = model_.source.starts_with("simulated:");
  if (snapshot.measured_body && snapshot.measured_body != saved_body_) {
    saved_body_ = snapshot.measured_body;
    if (!person_.body || !(*person_.body == *snapshot.measured_body)) {
      person_.body = *snapshot.measured_body;
      if (const Result<void> saved = people_.save(person_); !saved)
        tell(ToastKind::Warning, saved.error().message);
      refresh_people();
    }
  }
  if (snapshot.swing && snapshot.swing != last_swing_) take_swing(snapshot);
  if (snapshot.loop != last_loop_) {
    if (model_.is_sound_on) {
      if (snapshot.loop == LoopState::Ready) sounds_.play(Tone::Ready);
      if (snapshot.loop == LoopState::Swinging) sounds_.play(Tone::Swing);
      if (snapshot.loop == LoopState::Replay) sounds_.play(Tone::Answer);
    }
    if (snapshot.loop == LoopState::Replay) replay_until_s_ = time_s + kReplay_s;
    last_loop_ = snapshot.loop;
  }
  model_.replay_seconds_left = std::max(0.0, replay_until_s_ - time_s);
}

// What went wrong with a camera, with the name that its list shows and without the command line's advice.
std::shared_ptr<const CoachSnapshot> WindowProgram::in_the_windows_words(
    std::shared_ptr<const CoachSnapshot> snapshot) {
  if (snapshot->source_state != SourceState::Lost || !snapshot->source.starts_with(kCamera)) return snapshot;
  if (snapshot == told_lost_) return worded_lost_;
  told_lost_ = snapshot;
  const std::string path =
      snapshot->source.substr(kCamera.size(), snapshot->source.find('?') - kCamera.size());
  std::string name = "The camera";
  for (const CameraEntry& camera : model_.cameras)
    if (camera.source == std::string(kCamera) + path && camera.name != camera.source) name = camera.name;
  CoachSnapshot worded = *snapshot;
  std::error_code failed;
  if (!std::filesystem::exists(path, failed)) {
    worded.source_message = name + " is not plugged in. Plug it in again: it is used by itself.";
  } else if (const std::size_t at = worded.source_message.find("camera " + path); at != std::string::npos) {
    worded.source_message.replace(at, path.size() + 7, name);
  }
  worded_lost_ = std::make_shared<const CoachSnapshot>(std::move(worded));
  return worded_lost_;
}

void WindowProgram::take_swing(const CoachSnapshot& snapshot) {
  last_swing_ = snapshot.swing;
  last_swing_id_.clear();
  if (!snapshot.swing->pictures || snapshot.swing->pair.analysis.path.empty()) return;
  auto swing = std::make_shared<AnalyzedSwing>(*snapshot.swing);
  swing->pictures = make_shared_store(swing->pictures);
  model_.replay = make_opened("", "Last swing", swing, false);
  keep_swing(std::move(swing));
}

void WindowProgram::keep_swing(std::shared_ptr<const AnalyzedSwing> swing) {
  if (!library_) return;
  SwingFacts facts;
  facts.recorded_at = wall_time_now();
  facts.person = person_.name;
  facts.coach = model_.coach;
  facts.camera = model_.snapshot ? model_.snapshot->source : model_.source;
  keeping_->start(
      "Keeping the swing",
      [this, swing, facts](const Progress& progress) -> Result<JobQueue::Finish> {
        Result<SwingDraft> draft = library_->begin(facts);
        if (!draft) return tl::unexpected(draft.error());
        if (const Result<void> added = add_answer(*draft, *swing); !added)
          return tl::unexpected(added.error());
        if (const Result<void> written = write_film(*swing, draft->path("film.mp4"), progress); !written)
          return tl::unexpected(written.error());
        const Result<Swing> kept = library_->keep(*std::move(draft), progress);
        if (!kept) return tl::unexpected(kept.error());
        return JobQueue::Finish([this, id = kept->id] {
          last_swing_id_ = id;
          if (model_.opened && model_.opened->id.empty()) model_.opened->id = id;
          refresh_swings();
          tell(ToastKind::Good, "The swing is kept in the library.");
        });
      },
      false);
}

void WindowProgram::choose_source(const std::string& source, bool is_remembered,
                                  const std::optional<PictureMode>& mode) {
  model_.source = source;
  model_.mode = mode;
  std::string wish;
  if (mode) wish = "?width=" + std::to_string(mode->width) + "&height=" + std::to_string(mode->height);
  if (mode && mode->fps > 0) wish += "&fps=" + decimal(mode->fps, 2);
  if (mode && !mode->format.empty()) wish += "&format=" + mode->format;
  live_->set_source(source + wish);
  list_source(source);
  if (!is_remembered) return;
  Remembered& remembered = memory_->remembered;
  remembered.source = source;
  remembered.width = mode ? mode->width : 0;
  remembered.height = mode ? mode->height : 0;
  remembered.fps = mode ? mode->fps : 0;
  remembered.format = mode ? mode->format : std::string();
  memory_->save();
}

void WindowProgram::choose_coach(const std::string& source) {
  const bool is_file = std::filesystem::exists(source);
  const Result<MotionFormat> format = is_file ? motion_format(source) : MotionFormat{};
  if (!format || (is_file && *format == MotionFormat::PoseTrack)) return look_at_coach(source);
  Result<Reference> reference = is_file ? references_.add_motion_file(source) : references_.find(source);
  if (is_file && !reference) reference = references_.find(std::filesystem::path(source).stem().string());
  if (!reference) return tell(ToastKind::Warning, reference.error().message);
  if (reference->is_pictures) return choose_filmed_coach(*reference);
  Result<Motion> motion = load_reference(references_, reference->source);
  if (!motion) return tell(ToastKind::Warning, motion.error().message);
  if (is_file) refresh_coaches();
  live_->runner().request(
      [motion = *std::move(motion), source = reference->source](CoachPipeline& pipeline) mutable {
        pipeline.set_coach(std::move(motion), source);
      });
  remember_coach(reference->source);
}

void WindowProgram::remember_coach(const std::string& source) {
  model_.coach = source;
  if (person_.coach == source) return;
  change_person([&](Person& person) { person.coach = source; });
}

void WindowProgram::take_snapshot() {
  if (const std::optional<Frame> frame = live_->runner().newest_frame()) keep_picture(*frame->image);
}

void WindowProgram::keep_shot(const Image& picture) {
  keep_picture(picture);
}

void WindowProgram::keep_picture(const Image& picture) {
  const Result<std::filesystem::path> path = file_for_now(places_.library / "Pictures", "picture", ".png");
  if (!path) return tell(ToastKind::Warning, path.error().message);
  if (const Result<void> written = write_png(*path, picture); !written)
    return tell(ToastKind::Warning, written.error().message);
  tell(ToastKind::Good, "Picture kept: " + path->filename().string(), "Show",
       intent::ShowFolder{path->parent_path().string()});
}

// Into a draft of the library: what a sudden end leaves of it is found and offered at the next start.
void WindowProgram::record(bool is_on) {
  if (!library_) return tell(ToastKind::Warning, model_.library_message);
  if (is_on) {
    SwingFacts facts;
    facts.recorded_at = wall_time_now();
    facts.person = person_.name;
    facts.hand = person_.hand;
    facts.coach = model_.coach;
    facts.camera = model_.snapshot ? model_.snapshot->source : model_.source;
    facts.notes = "Recorded session";
    Result<SwingDraft> draft = library_->begin(facts);
    if (!draft) return tell(ToastKind::Warning, draft.error().message);
    if (const Result<void> started = live_->start_recording(draft->path("film.mkv").string()); !started)
      return tell(ToastKind::Warning, started.error().message);
    recording_ = *std::move(draft);
    return;
  }
  const double seconds = live_->recording().seconds;
  const Result<std::string> film = live_->stop_recording();
  if (!film) tell(ToastKind::Warning, film.error().message);
  if (!recording_) return;
  // Keeping digests the film: not on this thread. Jobs can be copied, drafts cannot.
  recording_->facts().seconds = seconds;
  const auto draft = std::make_shared<SwingDraft>(*std::exchange(recording_, std::nullopt));
  keeping_->start(
      "Keeping the session",
      [this, draft](const Progress& progress) -> Result<JobQueue::Finish> {
        const Result<Swing> kept = library_->keep(std::move(*draft), progress);
        if (!kept) return tl::unexpected(kept.error());
        return JobQueue::Finish([this, id = kept->id] {
          refresh_swings();
          tell(ToastKind::Good, "The session is in the library.", "Review", intent::OpenSwing{id});
        });
      },
      false);
}

void WindowProgram::refresh_cameras() {
  const std::string used = model_.source;
  std::string used_name;
  for (const CameraEntry& camera : model_.cameras)
    if (camera.source == used) used_name = camera.name;
  camera_files_ = camera_files(devices_.cameras);
  model_.cameras.clear();
  for (FoundCamera& camera : find_cameras(devices_.cameras)) {
    std::vector<PictureMode> modes;  // each at its fastest
    for (const CameraMode& mode : camera.modes)
      modes.push_back({mode.width, mode.height, mode.frame_rates.empty() ? 0 : mode.frame_rates.front(),
                       pixel_format_name(mode.pixel_format)});
    model_.cameras.push_back(
        {std::move(camera.source), std::move(camera.name), std::move(camera.detail), std::move(modes)});
  }
  model_.cameras.push_back({"simulated:swing", "Simulated student, full swing", "No camera needed", {}});
  model_.cameras.push_back({"simulated:putt", "Simulated student, putt", "No camera needed", {}});
  list_source(used, used_name);
}

void WindowProgram::look_for_cameras() {
  constexpr double kEvery_s = 1;
  if (std::abs(time_s_ - looked_for_cameras_s_) < kEvery_s) return;
  looked_for_cameras_s_ = time_s_;
  if (camera_files(devices_.cameras) != camera_files_) refresh_cameras();
}

// What is used is among what can be chosen: a film, a camera that is unplugged now.
void WindowProgram::list_source(const std::string& source, const std::string& known_name) {
  const bool is_listed = std::any_of(model_.cameras.begin(), model_.cameras.end(),
                                     [&](const CameraEntry& camera) { return camera.source == source; });
  if (source.empty() || is_listed) return;
  std::error_code failed;
  const bool is_film = std::filesystem::is_regular_file(source, failed);
  model_.cameras.push_back({source,
                            is_film              ? std::filesystem::path(source).filename().string()
                            : known_name.empty() ? source
                                                 : known_name,
                            is_film                         ? "A film: " + source
                            : source.starts_with("camera:") ? "Not plugged in now"
                                                            : "As you wrote it",
                            {}});
}

}  // namespace posecoach
