// The one table of commands and their keys.
#include "ui/screens/key_map.h"

namespace posecoach {
namespace {

constexpr KeyPress kNone{};

constexpr KeyPress plain(Key key) {
  return {key, false, false};
}
constexpr KeyPress shift(Key key) {
  return {key, true, false};
}
constexpr KeyPress control(Key key) {
  return {key, false, true};
}
constexpr KeyPress control_shift(Key key) {
  return {key, true, true};
}

constexpr KeyBinding everywhere(Command command, std::string_view name, std::string_view words,
                                KeyPress first, KeyPress second = kNone) {
  return {command, name, KeyGroup::Everywhere, kOnAll, words, {first, second}};
}
constexpr KeyBinding live(Command command, std::string_view name, std::string_view words, KeyPress first,
                          KeyPress second = kNone) {
  return {command, name, KeyGroup::Live, kOnLive, words, {first, second}};
}
constexpr KeyBinding player(Command command, std::string_view name, std::string_view words, KeyPress first,
                            KeyPress second = kNone) {
  return {command, name, KeyGroup::Player, kOnReview, words, {first, second}};
}
constexpr KeyBinding review(Command command, std::string_view name, std::string_view words, KeyPress first,
                            KeyPress second = kNone) {
  return {command, name, KeyGroup::Review, kOnReview, words, {first, second}};
}
constexpr KeyBinding library(Command command, std::string_view name, std::string_view words, KeyPress first,
                             KeyPress second = kNone) {
  return {command, name, KeyGroup::Library, kOnLibrary, words, {first, second}};
}
constexpr KeyBinding also_on(KeyBinding binding, unsigned screens) {
  binding.screens |= screens;
  return binding;
}
constexpr KeyBinding repeated(KeyBinding binding) {
  binding.is_repeated = true;
  return binding;
}
constexpr KeyBinding fixed(KeyBinding binding) {
  binding.is_fixed = true;
  return binding;
}

using enum Command;

constexpr std::array kBindings = {
    everywhere(ShowKeys, "keys", "This sheet", plain(Key::F1), plain(Key::Question)),
    everywhere(ShowLive, "live", "Live", control(Key::Digit1)),
    everywhere(ShowReview, "review", "Review", control(Key::Digit2)),
    everywhere(ShowLibrary, "library", "Library", control(Key::Digit3)),
    everywhere(ShowSetUp, "set_up", "Set-up", control(Key::Digit4)),
    everywhere(FullScreen, "full_screen", "Full screen", plain(Key::F11)),
    fixed(everywhere(Back, "back", "Back, close", plain(Key::Escape))),
    everywhere(Quit, "quit", "Quit", control(Key::Q)),

    live(HandsFree, "hands_free", "Hands-free on, off", plain(Key::H), plain(Key::Space)),
    live(Measure, "measure", "Measure my body", plain(Key::B)),
    live(Record, "record", "Record the session", plain(Key::R), control(Key::Enter)),
    also_on(live(Snapshot, "snapshot", "Keep this picture", plain(Key::S), shift(Key::Enter)), kOnReview),
    also_on(live(Mirror, "mirror", "Mirror the picture", plain(Key::M)), kOnReview),
    live(ChangePace, "pace", "Coach waits or plays", plain(Key::P)),
    live(ReviewLast, "review_last", "Review the last swing", plain(Key::Enter)),

    player(PlayPause, "play_pause", "Play, pause", plain(Key::Space), plain(Key::K)),
    repeated(player(StepBack, "step_back", "One picture back", plain(Key::Left), plain(Key::Comma))),
    repeated(player(StepForward, "step_on", "One picture on", plain(Key::Right), plain(Key::Period))),
    repeated(player(JumpBack, "jump_back", "A tenth back", plain(Key::PageUp), shift(Key::Left))),
    repeated(player(JumpForward, "jump_on", "A tenth on", plain(Key::PageDown), shift(Key::Right))),
    repeated(player(SmallJumpBack, "small_jump_back", "A hundredth back", shift(Key::PageUp))),
    repeated(player(SmallJumpForward, "small_jump_on", "A hundredth on", shift(Key::PageDown))),
    player(PreviousEvent, "position_before", "Position before", control(Key::Left)),
    player(NextEvent, "position_after", "Position after", control(Key::Right)),
    player(ToStart, "first_picture", "First picture", plain(Key::Home)),
    player(ToEnd, "last_picture", "Last picture", plain(Key::End)),
    player(Slower, "slower", "Slower", plain(Key::Down), plain(Key::LeftBracket)),
    player(Faster, "faster", "Faster", plain(Key::Up), plain(Key::RightBracket)),
    player(NormalSpeed, "normal_speed", "Normal speed", plain(Key::Backspace)),
    player(ShuttleBack, "shuttle_back", "Backwards, faster", plain(Key::J)),
    player(ShuttleForward, "shuttle_on", "Forwards, faster", plain(Key::L)),
    player(MarkIn, "mark_in", "Loop from here (A)", plain(Key::I)),
    player(MarkOut, "mark_out", "Loop to here (B)", plain(Key::O)),
    player(ToggleLoop, "loop", "Loop on, off", shift(Key::L)),
    player(ClearMarks, "clear_marks", "Forget A and B", shift(Key::I)),
    player(Position1, "position_1", "To position 1", plain(Key::Digit1)),
    player(Position2, "position_2", "To position 2", plain(Key::Digit2)),
    player(Position3, "position_3", "To position 3", plain(Key::Digit3)),
    player(Position4, "position_4", "To position 4", plain(Key::Digit4)),
    player(Position5, "position_5", "To position 5", plain(Key::Digit5)),
    player(Position6, "position_6", "To position 6", plain(Key::Digit6)),
    player(Position7, "position_7", "To position 7", plain(Key::Digit7)),
    player(Position8, "position_8", "To position 8", plain(Key::Digit8)),

    review(FrontView, "front_view", "3D from the front", plain(Key::F)),
    review(SideView, "side_view", "3D from the side", plain(Key::D)),
    review(TopView, "top_view", "3D from above", plain(Key::T)),
    repeated(review(TurnLeft, "turn_left", "Turn 3D left", plain(Key::Q))),
    repeated(review(TurnRight, "turn_right", "Turn 3D right", plain(Key::E))),
    repeated(review(ZoomIn, "zoom_in", "Film larger", control(Key::Plus), control(Key::Equal))),
    repeated(review(ZoomOut, "zoom_out", "Film smaller", control(Key::Minus))),
    review(ZoomWhole, "zoom_whole", "Whole film", control(Key::Digit0)),
    also_on(review(ToggleGolfer, "golfer", "Golfer large, whole film", plain(Key::Z)), kOnLive),
    also_on(review(ChangeFigures, "figures", "Skeletons on, off", plain(Key::X)), kOnLive),
    review(SideBySide, "side_by_side", "Two swings beside", plain(Key::F8)),
    review(Superpose, "superpose", "Two swings in one", plain(Key::F9)),
    review(PreviousAdvice, "advice_before", "Advice before", shift(Key::A)),
    review(NextAdvice, "advice_after", "Next advice", plain(Key::A)),
    review(KeyImage, "key_image", "Key picture on, off", plain(Key::Insert)),
    repeated(review(EventEarlier, "event_earlier", "Position earlier", control_shift(Key::Left))),
    repeated(review(EventLater, "event_later", "Position later", control_shift(Key::Right))),
    review(DrawLine, "draw_line", "Draw a line", plain(Key::N)),
    review(DrawAngle, "draw_angle", "Draw an angle", plain(Key::V)),
    review(DeleteDrawing, "delete_drawing", "Delete a drawing", plain(Key::Delete)),
    review(Undo, "undo", "Undo", control(Key::Z)),
    review(Redo, "redo", "Redo", control(Key::Y), control_shift(Key::Z)),

    also_on(library(ToggleStar, "star", "Star", plain(Key::B)), kOnReview),
    library(MoveToTrash, "trash", "To the trash", plain(Key::Delete)),
    library(Search, "search", "Search", control(Key::F), plain(Key::Slash)),
};

constexpr bool is_in_order() {
  for (std::size_t i = 0; i < kBindings.size(); ++i)
    if (static_cast<std::size_t>(kBindings[i].command) != i) return false;
  return kBindings.size() == static_cast<std::size_t>(kCommandCount);
}
static_assert(is_in_order());

}  // namespace

std::span<const KeyBinding> key_bindings() {
  return kBindings;
}

const KeyBinding& binding_of(Command command) {
  return kBindings[static_cast<std::size_t>(command)];
}

}  // namespace posecoach
