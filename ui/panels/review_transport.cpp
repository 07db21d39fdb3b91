#include <array>
#include <cmath>

#include "ui/panels/review_panels.h"
#include "ui/render/words.h"
#include "ui/widgets/controls.h"

namespace posecoach {
namespace {

std::string speed_words(double speed) {
  if (speed == 0.125) return "1/8×";
  if (speed == 0.25) return "1/4×";
  if (speed == 0.5) return "1/2×";
  return decimal(speed, speed == std::floor(speed) ? 0 : 2) + "×";
}

// The whole film as a bar: where it is, the marked part, the events. Dragging moves the film.
void draw_scrubber(const PanelContext& context, const Rect& area) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  Playback& playback = context.state.playback;
  playback.frame = shown_picture(context);
  const FilmMarks film = marks_of(*context.model.opened->review);
  const int last = std::max(1, film.count() - 1);
  const Rect bar{area.x + 8, area.centre().y - 3, area.width - 16, 6};
  const auto at = [&](int frame) { return bar.x + bar.width * std::clamp(frame, 0, last) / last; };
  const Interaction on = ui.region("scrubber", area, Focus::Never);
  if (on.held)
    playback =
        moved_to(playback, static_cast<int>(std::lround((on.mouse.x - bar.x) / bar.width * last)), film);
  ui.fill(bar, theme.hovered, 3);
  if (playback.in || playback.out) {
    const double from = at(playback.in.value_or(0)), to = at(playback.out.value_or(last));
    ui.fill({from, bar.y - 4, std::max(2.0, to - from), bar.height + 8}, theme.accent.with_alpha(0.22F), 3);
    for (const auto& [mark, word] : {std::pair(playback.in, "A"), std::pair(playback.out, "B")}) {
      if (!mark) continue;
      ui.fill({at(*mark) - 1, bar.y - 5, 2, bar.height + 10}, theme.accent);
      ui.text(TextStyle::Caption, {at(*mark), bar.y - 8}, word, theme.accent, Align::Centre);
    }
  }
  ui.fill({bar.x, bar.y, at(playback.frame) - bar.x, bar.height}, theme.accent, 3);
  for (const int event : film.events) ui.fill({at(event) - 1, bar.y - 2, 2, bar.height + 4}, theme.quiet, 1);
  // Key pictures are diamonds below the bar.
  for (const int picture : context.model.opened->marks.key_pictures) {
    const Vec2 tip(at(picture), bar.bottom() + 3);
    ui.polygon(std::array{tip, tip + Vec2(4.5, 5), tip + Vec2(0, 10), tip + Vec2(-4.5, 5)}, theme.warning);
  }
  ui.disc({at(playback.frame), bar.centre().y}, on.held || on.hovered ? 9 : 7.5, theme.text);
  if (on.hovered) ui.use_hand_pointer();
}

}  // namespace

void draw_transport(const PanelContext& context, const Rect& area) {
  if (!context.model.opened) return;
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  const ReviewSwing& review = *context.model.opened->review;
  const std::vector<int> stops = stops_of(review, context.model.opened->marks);
  FilmMarks film = marks_of(review);
  film.stops = stops;
  Playback& playback = context.state.playback;
  playback.frame = shown_picture(context);
  Rect row = area;
  struct Deed {
    Icon icon;
    PlaybackCommand deed;
    Command command;
    std::string_view id, hint;
  };
  const std::array<Deed, 5> deeds = {{
      {Icon::ToStart, PlaybackCommand::PreviousEvent, Command::PreviousEvent, "before", "Position before"},
      {Icon::StepBack, PlaybackCommand::StepBack, Command::StepBack, "back", "One picture back"},
      {playback.is_playing ? Icon::Pause : Icon::Play, PlaybackCommand::PlayPause, Command::PlayPause, "play",
       "Play, pause"},
      {Icon::StepForward, PlaybackCommand::StepForward, Command::StepForward, "on", "One picture on"},
      {Icon::ToEnd, PlaybackCommand::NextEvent, Command::NextEvent, "after", "Position after"},
  }};
  for (const Deed& deed : deeds) {
    const bool is_play = deed.command == Command::PlayPause;
    const std::string hint = context.hint(deed.hint, deed.command);
    const Button button{.id = deed.id,
                        .icon = deed.icon,
                        .look = is_play ? ButtonLook::Primary : ButtonLook::Quiet,
                        .hint = hint};
    if (draw_button(ui, row.take_left(is_play ? 44 : 36, 4), button))
      playback = applied(playback, deed.deed, film);
  }
  row.take_left(6);
  const double seconds =
      film.count() > 0 ? film.times_s[static_cast<std::size_t>(playback.frame)] - film.times_s.front() : 0;
  Rect clock = row.take_left(96, 6);
  ui.text_in(TextStyle::Strong, clock.take_top(0.5 * clock.height).moved(0, 3), decimal(seconds, 2) + " s",
             theme.text);
  ui.text_in(TextStyle::Caption, clock.moved(0, -3),
             std::to_string(playback.frame + 1) + " of " + std::to_string(film.count()), theme.quiet);
  const std::string phase = student_phase(review.analysis(), playback.frame);
  Rect right = row.take_right(150 + 84 + 44, 8);
  ui.text_in(TextStyle::Title, right.take_left(150, 8), phase, theme.text, Align::Right);
  std::vector<Choice> speeds;
  int chosen = -1;
  for (std::size_t i = 0; i < std::size(kSpeeds); ++i) {
    speeds.push_back({speed_words(kSpeeds[i]), ""});
    if (kSpeeds[i] == playback.speed) chosen = static_cast<int>(i);
  }
  const std::string shown =
      (playback.shuttle < 0 ? "− " : "") + speed_words(playback.speed * std::abs(playback.shuttle));
  const int picked = draw_dropdown(ui, "speed", right.take_left(76, 6).inset(0, 3), shown, speeds, chosen);
  if (picked >= 0) playback.speed = kSpeeds[picked];
  const std::string loop_hint = context.hint("Loop", Command::ToggleLoop);
  const Button loop{.id = "loop",
                    .icon = Icon::Loop,
                    .look = ButtonLook::Quiet,
                    .hint = loop_hint,
                    .is_on = playback.loop != LoopMode::Once};
  if (draw_button(ui, right.take_left(38), loop))
    playback = applied(playback, PlaybackCommand::ToggleLoop, film);
  if (row.width > 60) draw_scrubber(context, row);
}

}  // namespace posecoach
