// Everything that the window shows, as values: what the program knows (WindowModel, made anew by the program
// for each frame) and where the user is in it (WindowState, changed by the screens).
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/pipeline/coach_snapshot.h"
#include "ui/render/overlay_scene.h"
#include "ui/review/film_zoom.h"
#include "ui/review/live_framing.h"
#include "ui/review/mark_edit.h"
#include "ui/review/orbit.h"
#include "ui/review/playback.h"
#include "ui/review/review_swing.h"
#include "ui/screens/intents.h"

namespace posecoach {

struct CameraEntry {
  std::string source;  // "camera:/dev/v4l/by-id/..."
  std::string name, detail;
  std::vector<PictureMode> modes;
};

struct CoachChoice {
  std::string id, title, detail;
};

struct PersonChoice {
  std::string id, name;
  Handedness hand = Handedness::Right;
  std::optional<double> height_m;
  bool is_measured = false;
};

struct SwingCard {
  std::string id, title, when, person, coach, stroke, notes;
  std::string date;  // `when` with its date in digits, for searching
  std::optional<double> score_percent;
  double seconds = 0;
  bool is_starred = false, is_trashed = false;
  std::string unreadable;  // why the swing cannot be opened; empty when it can
  std::shared_ptr<const Image> thumbnail;
};

struct Job {
  int id = 0;
  std::string title, stage;
  double fraction = -1;
};

enum class ToastKind { Information, Good, Warning };
struct Toast {
  int id = 0;
  ToastKind kind = ToastKind::Information;
  std::string text;
  std::string action;            // "Undo"; empty for none
  std::optional<Intent> intent;  // of the action
};

// The picture of a film that is there now: the wanted one, or another while it is being fetched.
struct ShownPicture {
  int frame = 0;
  std::shared_ptr<const Image> image;  // null where none is there
  double waited_s = 0;                 // for the wanted one
  bool is_wanted_unreadable = false;   // it will never come
};
using PictureLookup = std::function<std::optional<ShownPicture>(int wanted)>;

// A swing that is being looked at.
struct OpenedSwing {
  std::string id, title, detail;
  std::shared_ptr<const ReviewSwing> review;  // never null
  PictureLookup picture;
  bool is_starred = false;
  Marks marks;  // made by hand
};

// A recording that the program's sudden end left unfinished.
struct LeftoverEntry {
  std::string folder, title, detail;
};

// A folder's content, for choosing a file.
struct FolderEntry {
  std::string name, path, detail;
  bool is_folder = false;
};
struct FolderListing {
  std::string path, parent;  // parent empty at the top
  std::vector<FolderEntry> places, entries;
  std::string message;  // why it cannot be listed
};

struct WindowModel {
  std::shared_ptr<const CoachSnapshot> snapshot;  // null before the first
  bool is_simulated = false;                      // nobody real is before the camera
  Pace pace = Pace::Follow;
  double ghost_speed = 1;
  bool is_recording = false;
  double recorded_s = 0;
  std::uint64_t recorded_frames = 0, recording_lost = 0;
  // The replay of the last swing, while the loop shows it.
  std::optional<OpenedSwing> replay;
  double replay_seconds_left = 0;

  std::optional<OpenedSwing> opened, compared;
  std::vector<SwingCard> swings;
  std::string library_message;  // why the library is not there

  std::vector<CameraEntry> cameras;
  std::string source;  // as chosen
  std::optional<PictureMode> mode;
  std::vector<CoachChoice> coaches;
  std::string coach;
  std::vector<PersonChoice> people;
  std::string person;

  ThemeKind theme = ThemeKind::Dark;
  Palette palette = Palette::RedGreen;
  double text_size = 1;
  bool has_sound = false, is_sound_on = true;
  std::string folder;  // where swings are kept
  KeyMap keys;
  FolderListing listing;
  std::vector<LeftoverEntry> leftovers;

  std::vector<Job> jobs;
  std::vector<Toast> toasts;
};

enum class ScreenName { Live, Review, Library, SetUp };

enum class CompareLook { SideBySide, Superposed };

// Which key is being chosen in the key sheet.
struct KeyChoice {
  Command command;
  std::size_t place = 0;
  std::optional<KeyPress> wanted = {};  // that another command has
};

// What a file is chosen for.
enum class BrowseFor { Swing, Coach, Source };

struct WindowState {
  ScreenName screen = ScreenName::Live;
  bool shows_keys = false, is_changing_keys = false;
  std::optional<KeyChoice> key_choice;
  bool is_mirrored = false;   // of the pictures shown only; nothing stored changes
  bool frames_golfer = true;  // live and in the replay: he is shown as large as fits
  LiveFraming framing;
  bool hides_first_steps = false;  // until the next start

  Playback replay{.is_playing = true, .speed = 0.5, .loop = LoopMode::Whole};
  Playback playback;
  std::shared_ptr<const ReviewSwing> played;  // whose playback that is
  std::string played_id;
  Orbit orbit = kFrontOrbit;
  bool fits_golfer = true;  // the film is as large as the golfer lets it be; `zoom` follows
  FilmZoom zoom;
  FigureShow figures = FigureShow::Both;  // over the films
  DrawingTool tool;
  std::optional<std::size_t> chosen_drawing;
  MarkHistory history;
  std::optional<std::pair<int, int>> dragged_event;  // place among the events, picture
  Rect film_area;                                    // where the films were drawn last
  CompareLook compare = CompareLook::SideBySide;
  int chosen_advice = -1;
  bool is_picking_second = false;

  std::string search;
  int filter = 0;  // of the library: all, starred, trash
  std::string selected;
  std::string notes_of, notes;  // being written
  std::string typed_source, typed_name, typed_height, typed_import;
  BrowseFor browse_for = BrowseFor::Swing;
  bool hides_leftovers = false;  // until the next start
};

}  // namespace posecoach
