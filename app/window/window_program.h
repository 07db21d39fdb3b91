// The program behind the window: it owns the live pipeline, the library and the long work, makes the window's
// model anew for each frame, and does what the user wants.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "app/window/job_queue.h"
#include "app/window/live_session.h"
#include "app/window/picture_fetcher.h"
#include "app/window/sounds.h"
#include "core/session/library.h"
#include "core/session/person.h"
#include "core/session/places.h"
#include "core/session/references.h"
#include "core/vision/pose_tracker.h"
#include "ui/screens/window_model.h"

namespace posecoach {

struct LiveArguments {
  std::string source = {}, coach = {}, person = {};  // empty: as last time
  PoseTrackerOptions pose = {};
};

class Memory;

class WindowProgram {
 public:
  // Errors: the pose networks are missing.
  static Result<std::unique_ptr<WindowProgram>> make(const LiveArguments& arguments,
                                                     LiveDevices devices = {});
  ~WindowProgram();

  // What the window shows now; `state` tells where the user is.
  const WindowModel& model(double time_s, WindowState& state);
  void perform(const Intents& intents, WindowState& state);
  // Whether something will change soon without the user: how long the window may sleep.
  double longest_sleep_s(const WindowState& state) const;
  bool wants_to_quit() const { return wants_to_quit_; }
  bool takes_full_screen() { return std::exchange(wants_full_screen_, false); }
  // A part of the window that is to be kept as a picture, and where to.
  std::optional<Rect> takes_shot() { return std::exchange(wanted_shot_, std::nullopt); }
  void keep_shot(const Image& picture);

 private:
  WindowProgram(const LiveArguments& arguments, LiveDevices devices);
  Result<void> start(const LiveArguments& arguments);

  // window_program_live.cpp
  void follow_loop(const CoachSnapshot& snapshot, double time_s);
  std::shared_ptr<const CoachSnapshot> in_the_windows_words(std::shared_ptr<const CoachSnapshot> snapshot);
  void take_swing(const CoachSnapshot& snapshot);
  void keep_swing(std::shared_ptr<const AnalyzedSwing> swing);
  void choose_source(const std::string& source, bool is_remembered,
                     const std::optional<PictureMode>& mode = {});
  void choose_coach(const std::string& source);
  // window_program_pictures.cpp: a film or a picture is all there is of him.
  void look_at_coach(const std::string& file);
  void choose_filmed_coach(const Reference& reference);
  void remember_coach(const std::string& source);
  void take_snapshot();
  void keep_picture(const Image& picture);
  void record(bool is_on);
  void refresh_cameras();
  void look_for_cameras();  // lists them again when one was plugged in or out
  void list_source(const std::string& source, const std::string& known_name = {});

  // window_program_library.cpp
  void refresh_swings();  // beside the window
  void change_card(const std::string& id, const std::function<void(SwingCard&)>& change);
  void open_swing(const std::string& id, bool as_second, WindowState& state);
  void import_file(const std::string& path, WindowState& state);
  void export_swing(const std::string& id, ExportKind kind);
  void make_reference(const std::string& id);
  void trash_swing(const std::string& id, WindowState& state);
  void refresh_coaches();

  // window_program_marks.cpp
  void set_marks(const std::string& id, const Marks& marks);
  void store_marks();

  // window_program_files.cpp
  void list_folder(const std::string& path);
  void show_folder(const std::string& path);
  void look_for_leftovers();
  void settle_leftover(const std::string& folder, Shelf shelf);

  // window_program_people.cpp
  void choose_person(const std::string& name);
  void change_person(const std::function<void(Person&)>& change);
  void refresh_people();
  void apply_person();
  void save_look();

  void perform_one(const Intent& intent, WindowState& state);
  void tell(ToastKind kind, std::string text, std::string action = {}, std::optional<Intent> intent = {});
  OpenedSwing make_opened(const std::string& id, std::string title,
                          std::shared_ptr<const AnalyzedSwing> swing, bool is_starred,
                          Reading reading = Reading::AsWanted);

  struct TimedToast {
    Toast toast;
    double until_s = 0;
  };

  PoseTrackerOptions pose_;
  LiveDevices devices_;
  Places places_;
  std::unique_ptr<Library> library_;
  References references_;
  People people_;
  std::unique_ptr<Memory> memory_;  // the settings
  Person person_;
  Sounds sounds_;
  WindowModel model_;
  double time_s_ = 0;
  int next_toast_ = 1;
  std::vector<TimedToast> toasts_;
  std::shared_ptr<const AnalyzedSwing> last_swing_;
  std::string last_swing_id_;  // once it is kept
  std::shared_ptr<const Skeleton> saved_body_;
  LoopState last_loop_ = LoopState::Off;
  double replay_until_s_ = 0;
  std::optional<ScreenName> wanted_screen_;
  std::shared_ptr<const CoachSnapshot> told_lost_, worded_lost_;  // the same, as it is shown
  std::vector<std::filesystem::path> camera_files_;
  double looked_for_cameras_s_ = 0;
  std::optional<Rect> wanted_shot_;
  std::vector<Leftover> leftovers_;
  bool is_storing_marks_ = false;
  std::map<std::string, std::shared_ptr<const Image>> thumbnails_;  // by their files' digests
  std::optional<SwingDraft> recording_;                             // the session that is being recorded
  bool wants_to_quit_ = false, wants_full_screen_ = false;
  std::unique_ptr<LiveSession> live_;
  // Last: their work uses the above. Keeping swings never waits for what the user asked for, nor he for it.
  std::unique_ptr<JobQueue> keeping_, jobs_;
};

}  // namespace posecoach
