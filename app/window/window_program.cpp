#include "app/window/window_program.h"

#include <algorithm>
#include <cmath>

#include "app/window/memory.h"
#include "core/base/log.h"
#include "core/base/overloaded.h"

namespace posecoach {
namespace {

constexpr double kToastStays_s = 7, kWarningStays_s = 14;

}  // namespace

WindowProgram::WindowProgram(const LiveArguments& arguments, LiveDevices devices)
    : pose_(arguments.pose),
      devices_(std::move(devices)),
      places_(find_places()),
      references_(places_.references()),
      people_(places_.people()),
      memory_(std::make_unique<Memory>(places_.settings_file())) {}

WindowProgram::~WindowProgram() {
  jobs_.reset();
  // What was recorded, swung and marked is kept before the window is gone.
  if (recording_ && live_) record(false);
  if (keeping_) keeping_->drain();
  keeping_.reset();
  live_.reset();
}

Result<std::unique_ptr<WindowProgram>> WindowProgram::make(const LiveArguments& arguments,
                                                           LiveDevices devices) {
  std::unique_ptr<WindowProgram> made(new WindowProgram(arguments, std::move(devices)));
  if (const Result<void> started = made->start(arguments); !started) return tl::unexpected(started.error());
  return made;
}

Result<void> WindowProgram::start(const LiveArguments& arguments) {
  Result<std::unique_ptr<LiveSession>> live = LiveSession::make(arguments.pose, devices_);
  if (!live) return tl::unexpected(live.error());
  live_ = *std::move(live);
  jobs_ = std::make_unique<JobQueue>([this](const Error& error) { tell(ToastKind::Warning, error.message); });
  keeping_ =
      std::make_unique<JobQueue>([this](const Error& error) { tell(ToastKind::Warning, error.message); });
  Result<std::unique_ptr<Library>> library = Library::open(places_.library);
  if (library)
    library_ = *std::move(library);
  else
    model_.library_message = library.error().message;
  if (!memory_->message().empty()) tell(ToastKind::Warning, memory_->message());
  model_.folder = places_.library.string();
  model_.has_sound = sounds_.has_device();
  const Remembered& remembered = memory_->remembered;
  model_.theme = remembered.theme == "light" ? ThemeKind::Light : ThemeKind::Dark;
  model_.palette = remembered.palette == "colour-blind" ? Palette::ColourBlindSafe : Palette::RedGreen;
  model_.text_size = remembered.text_size;
  model_.is_sound_on = remembered.is_sound_on;
  SavedKeyMap keys = key_map_from(remembered.keys);
  model_.keys = std::move(keys.keys);
  for (std::string& message : keys.messages) tell(ToastKind::Warning, std::move(message));
  person_ = people_.default_person(arguments.person.empty() ? remembered.person : arguments.person);
  if (!arguments.person.empty()) choose_person(arguments.person);
  if (!arguments.coach.empty()) person_.coach = arguments.coach;
  refresh_people();
  refresh_coaches();
  refresh_cameras();
  refresh_swings();
  look_for_leftovers();
  apply_person();
  choose_coach(person_.coach);
  std::string source = arguments.source.empty() ? remembered.source : arguments.source;
  const bool is_there = std::any_of(model_.cameras.begin(), model_.cameras.end(),
                                    [&](const CameraEntry& camera) { return camera.source == source; });
  // A camera of last time that is not plugged in must not stop anybody from starting.
  if (arguments.source.empty() && !is_there) source = model_.cameras.front().source;
  std::optional<PictureMode> mode;
  for (const CameraEntry& camera : model_.cameras)
    for (const PictureMode& can : camera.modes)
      if (camera.source == source && source == remembered.source && can.width == remembered.width &&
          can.height == remembered.height && std::abs(can.fps - remembered.fps) < 0.01 &&
          (remembered.format.empty() || can.format == remembered.format))
        mode = can;
  choose_source(source, false, mode);
  return {};
}

void WindowProgram::tell(ToastKind kind, std::string text, std::string action, std::optional<Intent> intent) {
  if (kind == ToastKind::Warning) log::warning(text);
  const double stays = kind == ToastKind::Warning ? kWarningStays_s : kToastStays_s;
  toasts_.push_back(
      {{next_toast_++, kind, std::move(text), std::move(action), std::move(intent)}, time_s_ + stays});
  constexpr std::size_t kMost = 4;
  if (toasts_.size() > kMost) toasts_.erase(toasts_.begin());
}

const WindowModel& WindowProgram::model(double time_s, WindowState& state) {
  time_s_ = time_s;
  (void)jobs_->finish_jobs();
  (void)keeping_->finish_jobs();
  if (wanted_screen_) state.screen = *std::exchange(wanted_screen_, std::nullopt);
  if (state.screen == ScreenName::SetUp) look_for_cameras();
  model_.snapshot = in_the_windows_words(live_->runner().snapshot());
  follow_loop(*model_.snapshot, time_s);
  const SessionRecording recording = live_->recording();
  model_.is_recording = recording.is_on;
  model_.recorded_s = recording.seconds;
  model_.recorded_frames = recording.written;
  model_.recording_lost = recording.lost;
  if (recording.is_on && !recording.problem.empty()) record(false);
  model_.jobs = jobs_->jobs();
  std::erase_if(toasts_, [&](const TimedToast& toast) { return toast.until_s < time_s; });
  model_.toasts.clear();
  for (const TimedToast& toast : toasts_) model_.toasts.push_back(toast.toast);
  return model_;
}

double WindowProgram::longest_sleep_s(const WindowState& state) const {
  constexpr double kFrame = 1.0 / 60, kLive = 1.0 / 30, kIdle = 0.2;
  if (state.screen == ScreenName::Live) return kLive;
  if (state.screen == ScreenName::Review && state.playback.is_playing) return kFrame;
  return jobs_->is_busy() || keeping_->is_busy() || !toasts_.empty() ? 0.05 : kIdle;
}

void WindowProgram::perform(const Intents& intents, WindowState& state) {
  for (const Intent& intent : intents) perform_one(intent, state);
}

void WindowProgram::perform_one(const Intent& intent, WindowState& state) {
  PipelineRunner& runner = live_->runner();
  std::visit(
      Overloaded{
          [&](const intent::ArmHandsFree&) { runner.request([](CoachPipeline& p) { p.arm(); }); },
          [&](const intent::DisarmHandsFree&) { runner.request([](CoachPipeline& p) { p.disarm(); }); },
          [&](const intent::MeasureBody&) { runner.request([](CoachPipeline& p) { p.start_measuring(); }); },
          [&](const intent::StopMeasuring&) { runner.request([](CoachPipeline& p) { p.stop_measuring(); }); },
          [&](const intent::SetPace& it) {
            model_.pace = it.pace;
            runner.request(
                [pace = it.pace, speed = model_.ghost_speed](CoachPipeline& p) { p.set_pace(pace, speed); });
          },
          [&](const intent::SetGhostSpeed& it) {
            model_.ghost_speed = it.speed;
            runner.request(
                [pace = model_.pace, speed = it.speed](CoachPipeline& p) { p.set_pace(pace, speed); });
          },
          [&](const intent::LeaveReplay&) { runner.request([](CoachPipeline& p) { p.dismiss_replay(); }); },
          [&](const intent::OpenLastSwing&) {
            if (!last_swing_) return;
            model_.opened = make_opened(last_swing_id_, "Last swing", last_swing_, false);
            model_.compared.reset();
            state.screen = ScreenName::Review;
            runner.request([](CoachPipeline& p) { p.dismiss_replay(); });
          },
          [&](const intent::StartRecording&) { record(true); },
          [&](const intent::StopRecording&) { record(false); },
          [&](const intent::TakeSnapshot&) { take_snapshot(); },
          [&](const intent::ChooseSource& it) { choose_source(it.source, true, it.mode); },
          [&](const intent::RetrySource&) { choose_source(model_.source, false, model_.mode); },
          [&](const intent::RefreshCameras&) { refresh_cameras(); },
          [&](const intent::ChooseCoach& it) { choose_coach(it.id); },
          [&](const intent::ChoosePerson& it) { choose_person(it.id); },
          [&](const intent::AddPerson& it) {
            Person person;
            person.name = it.name;
            if (const Result<void> saved = people_.save(person); !saved)
              return tell(ToastKind::Warning, saved.error().message);
            choose_person(it.name);
          },
          [&](const intent::SetHand& it) { change_person([&](Person& person) { person.hand = it.hand; }); },
          [&](const intent::SetHeight& it) {
            change_person([&](Person& person) { person.height_m = it.height_m; });
          },
          [&](const intent::OpenSwing& it) { open_swing(it.id, false, state); },
          [&](const intent::CompareWith& it) { open_swing(it.id, true, state); },
          [&](const intent::StopComparing&) { model_.compared.reset(); },
          [&](const intent::SetStar& it) {
            if (!library_) return;
            SwingChange change;
            change.star = it.is_starred;
            if (const Result<Swing> changed = library_->change(it.id, change); !changed)
              return tell(ToastKind::Warning, changed.error().message);
            if (model_.opened && model_.opened->id == it.id) model_.opened->is_starred = it.is_starred;
            change_card(it.id, [&](SwingCard& card) { card.is_starred = it.is_starred; });
          },
          [&](const intent::SetNotes& it) {
            if (!library_) return;
            SwingChange change;
            change.notes = it.notes;
            if (const Result<Swing> changed = library_->change(it.id, change); !changed)
              return tell(ToastKind::Warning, changed.error().message);
            change_card(it.id, [&](SwingCard& card) { card.notes = it.notes; });
          },
          [&](const intent::TrashSwing& it) { trash_swing(it.id, state); },
          [&](const intent::RestoreSwing& it) {
            if (!library_) return;
            if (const Result<Swing> restored = library_->restore(it.id); !restored)
              return tell(ToastKind::Warning, restored.error().message);
            change_card(it.id, [](SwingCard& card) { card.is_trashed = false; });
          },
          [&](const intent::MakeReference& it) { make_reference(it.id); },
          [&](const intent::ExportSwing& it) { export_swing(it.id, it.kind); },
          [&](const intent::ImportFile& it) { import_file(it.path, state); },
          [&](const intent::SetMarks& it) { set_marks(it.id, it.marks); },
          [&](const intent::KeepShown& it) { wanted_shot_ = it.area; },
          [&](const intent::ListFolder& it) { list_folder(it.path); },
          [&](const intent::ShowFolder& it) { show_folder(it.path); },
          [&](const intent::KeepLeftover& it) { settle_leftover(it.folder, Shelf::Kept); },
          [&](const intent::TrashLeftover& it) { settle_leftover(it.folder, Shelf::Trash); },
          [&](const intent::SetKeys& it) {
            model_.keys = it.keys;
            memory_->remembered.keys = model_.keys.saved(memory_->remembered.keys);
            memory_->save();
          },
          [&](const intent::CancelJob& it) { jobs_->cancel(it.id); },
          [&](const intent::DismissToast& it) {
            std::erase_if(toasts_, [&](const TimedToast& toast) { return toast.toast.id == it.id; });
          },
          [&](const intent::SetLook& it) {
            model_.theme = it.kind;
            model_.palette = it.palette;
            save_look();
          },
          [&](const intent::SetTextSize& it) {
            model_.text_size = it.factor;
            save_look();
          },
          [&](const intent::SetSound& it) {
            model_.is_sound_on = it.is_on;
            save_look();
          },
          [&](const intent::ToggleFullScreen&) { wants_full_screen_ = true; },
          [&](const intent::Quit&) { wants_to_quit_ = true; },
      },
      intent);
}

}  // namespace posecoach
