#include <cmath>

#include "ui/panels/live_panels.h"
#include "ui/panels/review_panels.h"
#include "ui/screens/key_map.h"
#include "ui/screens/screens.h"
#include "ui/widgets/controls.h"

namespace posecoach {
namespace {

constexpr double kSide = 290, kStateWide = 320, kMargin = 20, kStatus = 28, kBar = 58;

bool is_replaying(const WindowModel& model) {
  return model.replay && model.replay->review && model.snapshot && model.snapshot->loop == LoopState::Replay;
}

double answer_width(const Rect& inner) {
  return std::min(430.0, 0.42 * inner.width);
}

void use_keys(const PanelContext& context) {
  Ui& ui = context.ui;
  const WindowModel& model = context.model;
  const bool is_on = model.snapshot && model.snapshot->loop != LoopState::Off;
  if (is_replaying(model)) {
    if (context.pressed(Command::ReviewLast)) context.want(intent::OpenLastSwing{});
    if (context.pressed(Command::Back) || context.pressed(Command::PlayPause))
      context.want(intent::LeaveReplay{});
  }
  if (model.snapshot && model.snapshot->measuring && ui.take_key({Key::Escape}))
    context.want(intent::StopMeasuring{});
  if (context.pressed(Command::HandsFree)) {
    if (is_on)
      context.want(intent::DisarmHandsFree{});
    else
      context.want(intent::ArmHandsFree{});
  }
  if (context.pressed(Command::Measure)) context.want(intent::MeasureBody{});
  if (context.pressed(Command::Record)) {
    if (model.is_recording)
      context.want(intent::StopRecording{});
    else
      context.want(intent::StartRecording{});
  }
  if (context.pressed(Command::Snapshot)) context.want(intent::TakeSnapshot{});
  if (context.pressed(Command::Mirror)) context.state.is_mirrored = !context.state.is_mirrored;
  if (context.pressed(Command::ToggleGolfer)) context.state.frames_golfer = !context.state.frames_golfer;
  if (context.pressed(Command::ChangeFigures)) change_figures(context.state);
  if (context.pressed(Command::ChangePace))
    context.want(intent::SetPace{model.pace == Pace::Follow ? Pace::Play : Pace::Follow});
  if (context.pressed(Command::ReviewLast) && model.snapshot && model.snapshot->swing)
    context.want(intent::OpenLastSwing{});
}

bool has_camera(const WindowModel& model) {
  return std::any_of(model.cameras.begin(), model.cameras.end(),
                     [](const CameraEntry& camera) { return camera.source.starts_with("camera:"); });
}

// What is wrong with a coach is told of the coach's id.
std::string with_coaches_title(const WindowModel& model, const std::string& message) {
  for (const CoachChoice& coach : model.coaches)
    if (!coach.id.empty() && message.starts_with(coach.id + ": "))
      return coach.title + message.substr(coach.id.size());
  return message;
}

void draw_notes(const PanelContext& context, Rect area) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  const auto note = [&](std::string_view words, Icon icon, const Colour& ink) {
    const Pill pill{words, ink, colour_from_hex(0x0C1016).with_alpha(0.82F), icon};
    const double width = pill_width(ui, pill);
    if (width <= area.width) {
      const Rect line = area.take_top(28, 6);
      draw_pill(ui, {line.centre().x - 0.5 * width, line.y, width, line.height}, pill);
      return;
    }
    constexpr double kIcon = 26, kAbove = 7;
    constexpr int kMostLines = 3;
    const double text_width = area.width - kIcon - 18;
    const Rect box =
        area.take_top(ui.paragraph_height(TextStyle::Caption, text_width, words, kMostLines) + 2 * kAbove, 6);
    ui.fill(box, pill.paper, radius::kMedium);
    draw_icon(ui, icon, {box.x + 15, box.y + kAbove + 0.5 * ui.line_height(TextStyle::Caption)}, 14, ink);
    ui.paragraph(TextStyle::Caption, {box.x + 6 + kIcon, box.y + kAbove, text_width, box.height}, words, ink,
                 kMostLines);
  };
  if (context.model.is_simulated)
    note(has_camera(context.model) ? "The simulated student plays. Choose your camera in Set-up."
                                   : "No camera is plugged in, so a simulated student plays.",
         Icon::Information, theme.text);
  if (context.model.snapshot && !context.model.snapshot->coach_message.empty())
    note(context.model.snapshot->coach_message, Icon::Information, theme.text);
  if (context.model.snapshot && !context.model.snapshot->swing_message.empty())
    note(with_coaches_title(context.model, context.model.snapshot->swing_message), Icon::Warning,
         theme.warning);
}

void draw_replay_film(const PanelContext& context, const Rect& area) {
  WindowState& state = context.state;
  const FilmMarks film = marks_of(*context.model.replay->review);
  state.replay.loop = LoopMode::Whole;
  state.replay.is_playing = true;
  state.replay = advanced(state.replay, context.ui.elapsed_s(), film);
  draw_film(context, area,
            {.name = "replay",
             .swing = &*context.model.replay,
             .picture = state.replay.frame,
             .is_mirrored = state.is_mirrored,
             .zoom = state.frames_golfer ? golfer_zoom(*context.model.replay->review, area, state.is_mirrored)
                                         : FilmZoom{},
             .figures = state.figures,
             .says_when_late = false});
}

}  // namespace

void draw_live_screen(const PanelContext& context, const Rect& area) {
  const Theme film = film_theme(context.theme());
  Rect rest = area;
  draw_status_line(context, rest.take_bottom(kStatus));
  use_keys(context);
  const bool replays = is_replaying(context.model);
  if (replays)
    draw_replay_film(
        context, {rest.x, rest.y, rest.width - answer_width(rest.inset(kMargin)) - 2 * kMargin, rest.height});
  else
    draw_live_picture(context, rest);
  const ThemeScope scope(context.ui, film);
  Rect inner = rest.inset(kMargin);
  if (replays) {
    draw_replay(context, inner.take_right(answer_width(inner), kMargin));
    draw_notes(context, inner);
    return;
  }
  draw_notes(context, {rest.x + kStateWide, rest.y + kMargin, rest.width - kStateWide - kSide - 30, 80});
  draw_state_frame(context, rest);
  const Rect bar = inner.take_bottom(kBar, kMargin);
  Rect right = inner.take_right(std::min(kSide, inner.width));
  // How somebody stands is of interest while he is seen.
  if (context.model.snapshot && context.model.snapshot->source_state != SourceState::Live) right = {};
  const double checks = std::min(set_up_checks_height(context, right.width), right.height);
  if (checks > 0) draw_set_up_checks(context, right.take_top(checks, 12));
  const double address = std::min(address_advice_height(context, right.width), right.height);
  if (address > 60) draw_address_advice(context, right.take_top(address));
  Rect left = inner.take_left(std::min(kStateWide, inner.width));
  if (!context.model.snapshot || !context.model.snapshot->measuring) draw_state_banner(context, left);
  if (shows_first_steps(context.model, context.state))
    draw_first_steps(context, left.take_top(std::min(first_steps_height(context, left.width), left.height)));
  Theme dialog = film;
  dialog.surface = dialog.surface.with_alpha(0.94F);
  {
    const ThemeScope over(context.ui, dialog);
    draw_source_message(context, rest);
  }
  // Beside him: he wants to see how he stands.
  draw_measuring(context, {rest.x, rest.y, kStateWide + 2 * kMargin, rest.height - kBar - kMargin});
  const double bar_width = std::min(bar.width, 1096.0);
  draw_live_controls(context, {bar.centre().x - 0.5 * bar_width, bar.y, bar_width, bar.height});
}

Rect live_messages_area(const WindowModel& model, const Rect& area) {
  Rect rest = area;
  rest.take_bottom(kStatus + kMargin + kBar);
  if (is_replaying(model)) rest.take_right(kMargin + answer_width(area.inset(kMargin)));
  return rest;
}

}  // namespace posecoach
