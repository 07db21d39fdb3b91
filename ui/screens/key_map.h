// Which key does what, once: the screens ask it, the key sheet shows it.
#pragma once

#include <span>
#include <string_view>

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
  FrontView,
  SideView,
  TopView,
  SideBySide,
  Superpose,
  PreviousAdvice,
  NextAdvice,
  ToggleStar,
  MoveToTrash,
  Search
};

struct KeyBinding {
  Command command;
  KeyGroup group;
  std::string_view words;
  KeyPress first, second = {};  // either will do
};
std::span<const KeyBinding> key_bindings();

// Takes the command's key from this frame.
bool was_pressed(Ui& ui, Command command);
// "Star (B)".
std::string with_key(std::string_view words, Command command);

// Every key of the player group, applied.
Playback played_by_keys(Ui& ui, Playback playback, const FilmMarks& film);

}  // namespace posecoach
