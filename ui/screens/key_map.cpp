#include "ui/screens/key_map.h"

#include <algorithm>
#include <array>

namespace posecoach {
namespace {

constexpr KeyPress plain(Key key) {
  return {key, false, false};
}
constexpr KeyPress shift(Key key) {
  return {key, true, false};
}
constexpr KeyPress control(Key key) {
  return {key, false, true};
}

using enum Command;
using enum KeyGroup;

constexpr std::array kBindings = {
    KeyBinding{ShowKeys, Everywhere, "This sheet", plain(Key::F1), shift(Key::Slash)},
    KeyBinding{ShowLive, Everywhere, "Live", control(Key::Digit1)},
    KeyBinding{ShowReview, Everywhere, "Review", control(Key::Digit2)},
    KeyBinding{ShowLibrary, Everywhere, "Library", control(Key::Digit3)},
    KeyBinding{ShowSetUp, Everywhere, "Set-up", control(Key::Digit4)},
    KeyBinding{FullScreen, Everywhere, "Full screen", plain(Key::F11)},
    KeyBinding{Back, Everywhere, "Back, close", plain(Key::Escape)},
    KeyBinding{Quit, Everywhere, "Quit", control(Key::Q)},
    KeyBinding{HandsFree, Live, "Hands-free on, off", plain(Key::H), plain(Key::Space)},
    KeyBinding{Measure, Live, "Measure my body", plain(Key::B)},
    KeyBinding{Record, Live, "Record the session", plain(Key::R), control(Key::Enter)},
    KeyBinding{Snapshot, Live, "Keep this picture", plain(Key::S), shift(Key::Enter)},
    KeyBinding{Mirror, Live, "Mirror the picture", plain(Key::M)},
    KeyBinding{ChangePace, Live, "Coach waits or plays", plain(Key::P)},
    KeyBinding{ReviewLast, Live, "Review the last swing", plain(Key::Enter)},
    KeyBinding{PlayPause, Player, "Play, pause", plain(Key::Space), plain(Key::K)},
    KeyBinding{StepBack, Player, "One picture back", plain(Key::Left), plain(Key::Comma)},
    KeyBinding{StepForward, Player, "One picture on", plain(Key::Right), plain(Key::Period)},
    KeyBinding{JumpBack, Player, "A tenth back", plain(Key::PageUp), shift(Key::Left)},
    KeyBinding{JumpForward, Player, "A tenth on", plain(Key::PageDown), shift(Key::Right)},
    KeyBinding{SmallJumpBack, Player, "A hundredth back", shift(Key::PageUp)},
    KeyBinding{SmallJumpForward, Player, "A hundredth on", shift(Key::PageDown)},
    KeyBinding{PreviousEvent, Player, "Position before", control(Key::Left)},
    KeyBinding{NextEvent, Player, "Position after", control(Key::Right)},
    KeyBinding{ToStart, Player, "First picture", plain(Key::Home)},
    KeyBinding{ToEnd, Player, "Last picture", plain(Key::End)},
    KeyBinding{Slower, Player, "Slower", plain(Key::Down), plain(Key::LeftBracket)},
    KeyBinding{Faster, Player, "Faster", plain(Key::Up), plain(Key::RightBracket)},
    KeyBinding{NormalSpeed, Player, "Normal speed", plain(Key::Backspace)},
    KeyBinding{ShuttleBack, Player, "Play backwards, faster", plain(Key::J)},
    KeyBinding{ShuttleForward, Player, "Play forwards, faster", plain(Key::L)},
    KeyBinding{MarkIn, Player, "Loop from here (A)", plain(Key::I)},
    KeyBinding{MarkOut, Player, "Loop to here (B)", plain(Key::O)},
    KeyBinding{ToggleLoop, Player, "Loop on, off", shift(Key::L)},
    KeyBinding{ClearMarks, Player, "Forget A and B", shift(Key::I)},
    KeyBinding{FrontView, Review, "3D from the front", plain(Key::F)},
    KeyBinding{SideView, Review, "3D from the side", plain(Key::D)},
    KeyBinding{TopView, Review, "3D from above", plain(Key::T)},
    KeyBinding{SideBySide, Review, "Two swings beside", plain(Key::F8)},
    KeyBinding{Superpose, Review, "Two swings in one", plain(Key::F9)},
    KeyBinding{PreviousAdvice, Review, "Advice before", shift(Key::A)},
    KeyBinding{NextAdvice, Review, "Next advice", plain(Key::A)},
    KeyBinding{ToggleStar, Library, "Star", plain(Key::B)},
    KeyBinding{MoveToTrash, Library, "To the trash", plain(Key::Delete)},
    KeyBinding{Search, Library, "Search", control(Key::F), plain(Key::Slash)},
};

const KeyBinding& binding_of(Command command) {
  return *std::find_if(kBindings.begin(), kBindings.end(),
                       [&](const KeyBinding& binding) { return binding.command == command; });
}

constexpr std::array kPlayer = {
    std::pair(PlayPause, PlaybackCommand::PlayPause),
    std::pair(StepBack, PlaybackCommand::StepBack),
    std::pair(StepForward, PlaybackCommand::StepForward),
    std::pair(JumpBack, PlaybackCommand::JumpBack),
    std::pair(JumpForward, PlaybackCommand::JumpForward),
    std::pair(SmallJumpBack, PlaybackCommand::SmallJumpBack),
    std::pair(SmallJumpForward, PlaybackCommand::SmallJumpForward),
    std::pair(PreviousEvent, PlaybackCommand::PreviousEvent),
    std::pair(NextEvent, PlaybackCommand::NextEvent),
    std::pair(ToStart, PlaybackCommand::ToStart),
    std::pair(ToEnd, PlaybackCommand::ToEnd),
    std::pair(Slower, PlaybackCommand::Slower),
    std::pair(Faster, PlaybackCommand::Faster),
    std::pair(NormalSpeed, PlaybackCommand::NormalSpeed),
    std::pair(ShuttleBack, PlaybackCommand::ShuttleBack),
    std::pair(ShuttleForward, PlaybackCommand::ShuttleForward),
    std::pair(MarkIn, PlaybackCommand::MarkIn),
    std::pair(MarkOut, PlaybackCommand::MarkOut),
    std::pair(ToggleLoop, PlaybackCommand::ToggleLoop),
    std::pair(ClearMarks, PlaybackCommand::ClearMarks),
};

}  // namespace

std::string_view title_of(KeyGroup group) {
  switch (group) {
    case Everywhere:
      return "Everywhere";
    case Live:
      return "Live";
    case Player:
      return "Player";
    case Review:
      return "Review";
    case Library:
      return "Library";
  }
  return {};
}

std::span<const KeyBinding> key_bindings() {
  return kBindings;
}

bool was_pressed(Ui& ui, Command command) {
  const KeyBinding& binding = binding_of(command);
  return ui.take_key(binding.first) || (binding.second.key != Key::None && ui.take_key(binding.second));
}

std::string with_key(std::string_view words, Command command) {
  return std::string(words) + " (" + to_words(binding_of(command).first) + ")";
}

Playback played_by_keys(Ui& ui, Playback playback, const FilmMarks& film) {
  for (const auto& [command, deed] : kPlayer)
    while (was_pressed(ui, command)) playback = applied(playback, deed, film);
  constexpr int kEvents = 8;
  for (int i = 0; i < kEvents; ++i)
    if (ui.take_key({static_cast<Key>(static_cast<int>(Key::Digit1) + i)}) &&
        i < static_cast<int>(film.events.size()))
      playback = moved_to(playback, film.events[static_cast<std::size_t>(i)], film);
  return playback;
}

}  // namespace posecoach
