// Which key does what, in one table: the screens ask it, the key sheet shows it, the user changes it.
//
// Who owns the keyboard, first to last:
//   1. a text field that is being written in: every key but Esc and Tab, which leave it;
//   2. an open list or dialog: every key;
//   3. Tab and Shift+Tab walk from place to place; Enter presses the place that they ringed;
//   4. the commands below, of the screen that is shown;
//   5. arrow keys that no command took walk to the next place in their direction.
// Dear ImGui's own keyboard navigation is switched off.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/review/playback.h"
#include "ui/widgets/ui.h"

namespace posecoach {

enum class KeyGroup { Everywhere, Live, Player, Review, Library };
std::string_view title_of(KeyGroup group);

enum class Command {
  ShowKeys,
  ShowLive,
  ShowReview,
  ShowLibrary,
  ShowSetUp,
  FullScreen,
  Back,
  Quit,
  HandsFree,
  Measure,
  Record,
  Snapshot,
  Mirror,
  ChangePace,
  ReviewLast,
  PlayPause,
  StepBack,
  StepForward,
  JumpBack,
  JumpForward,
  SmallJumpBack,
  SmallJumpForward,
  PreviousEvent,
  NextEvent,
  ToStart,
  ToEnd,
  Slower,
  Faster,
  NormalSpeed,
  ShuttleBack,
  ShuttleForward,
  MarkIn,
  MarkOut,
  ToggleLoop,
  ClearMarks,
  Position1,
  Position2,
  Position3,
  Position4,
  Position5,
  Position6,
  Position7,
  Position8,
  FrontView,
  SideView,
  TopView,
  TurnLeft,
  TurnRight,
  ZoomIn,
  ZoomOut,
  ZoomWhole,
  ToggleGolfer,
  ChangeFigures,
  SideBySide,
  Superpose,
  PreviousAdvice,
  NextAdvice,
  KeyImage,
  EventEarlier,
  EventLater,
  DrawLine,
  DrawAngle,
  DeleteDrawing,
  Undo,
  Redo,
  ToggleStar,
  MoveToTrash,
  Search
};
inline constexpr int kCommandCount = static_cast<int>(Command::Search) + 1;

// Either of both does it; Key::None for none.
using Chords = std::array<KeyPress, 2>;

struct KeyBinding {
  Command command;
  std::string_view name;  // in the settings
  KeyGroup group;         // in the sheet
  unsigned screens;       // where it counts, of the bits below
  std::string_view words;
  Chords chords;             // unless the user says otherwise
  bool is_repeated = false;  // while the key stays down
  bool is_fixed = false;     // not the user's to change
};
inline constexpr unsigned kOnLive = 1, kOnReview = 2, kOnLibrary = 4, kOnSetUp = 8, kOnAll = 15;
// In the order of Command.
std::span<const KeyBinding> key_bindings();
const KeyBinding& binding_of(Command command);

// The user's keys. No two commands of one screen ever share one.
class KeyMap {
 public:
  KeyMap();  // the defaults

  const Chords& chords(Command command) const { return chords_[static_cast<std::size_t>(command)]; }
  bool is_changed(Command command) const;
  bool is_changed() const;
  // Which command has this key already, on a screen where `command` counts too.
  std::optional<Command> owner(const KeyPress& press, Command command) const;
  // Esc, Tab and Enter alone belong to the window.
  static bool is_free(const KeyPress& press);

  // Puts it into place 0 or 1; whoever had it loses it. Key::None takes the key away.
  void set(Command command, std::size_t place, const KeyPress& press);
  void reset(Command command);

  // What differs from the defaults, by name: "Left ,", "none"; names that this version does not know stay as
  // they are in `before`.
  std::map<std::string, std::string> saved(const std::map<std::string, std::string>& before = {}) const;

  bool operator==(const KeyMap&) const = default;

 private:
  std::array<Chords, static_cast<std::size_t>(kCommandCount)> chords_;
};

// What a file says; where that cannot be, the default counts, with one line that says so.
struct SavedKeyMap {
  KeyMap keys;
  std::vector<std::string> messages;
};
SavedKeyMap key_map_from(const std::map<std::string, std::string>& saved);

// Takes the command's key from this frame.
bool was_pressed(Ui& ui, const KeyMap& keys, Command command);
// "Space or K"; "none".
std::string key_words(const KeyMap& keys, Command command);
// "Star (B)".
std::string with_key(const KeyMap& keys, std::string_view words, Command command);

// Every key of the player group, applied.
Playback played_by_keys(Ui& ui, const KeyMap& keys, Playback playback, const FilmMarks& film);

}  // namespace posecoach
