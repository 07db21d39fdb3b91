#include "ui/panels/live_panels.h"
#include "ui/panels/review_panels.h"
#include "ui/render/words.h"
#include "ui/widgets/controls.h"

namespace posecoach {
namespace {

constexpr std::array kGhostSpeeds = {0.25, 0.5, 0.75, 1.0};

void draw_coach_choice(const PanelContext& context, const Rect& area) {
  std::vector<Choice> choices;
  int chosen = -1;
  std::string shown = "Choose a coach";
  for (std::size_t i = 0; i < context.model.coaches.size(); ++i) {
    const CoachChoice& coach = context.model.coaches[i];
    choices.push_back({coach.title, coach.detail});
    if (coach.id != context.model.coach) continue;
    chosen = static_cast<int>(i);
    shown = coach.title;
  }
  const int picked = draw_dropdown(context.ui, "coach", area, shown, choices, chosen, Icon::Coach);
  if (picked >= 0)
    context.want(intent::ChooseCoach{context.model.coaches[static_cast<std::size_t>(picked)].id});
}

void draw_pace(const PanelContext& context, Rect area) {
  const bool follows = context.model.pace == Pace::Follow;
  constexpr std::array<std::string_view, 2> kPaces = {"Coach waits", "Coach plays"};
  const int chosen = draw_segments(
      context.ui, "pace", area.take_left(follows ? area.width : area.width - 84, 8), kPaces, follows ? 0 : 1);
  if (chosen != (follows ? 0 : 1)) context.want(intent::SetPace{chosen == 0 ? Pace::Follow : Pace::Play});
  if (follows) return;
  std::vector<Choice> choices;
  int current = 0;
  for (std::size_t i = 0; i < kGhostSpeeds.size(); ++i) {
    choices.push_back({decimal(kGhostSpeeds[i], 2) + "×", ""});
    if (std::abs(kGhostSpeeds[i] - context.model.ghost_speed) < 0.01) current = static_cast<int>(i);
  }
  const int picked = draw_dropdown(context.ui, "ghost speed", area,
                                   decimal(context.model.ghost_speed, 2) + "×", choices, current);
  if (picked >= 0) context.want(intent::SetGhostSpeed{kGhostSpeeds[static_cast<std::size_t>(picked)]});
}

}  // namespace

void draw_live_controls(const PanelContext& context, const Rect& area) {
  Ui& ui = context.ui;
  const bool is_on = context.model.snapshot && context.model.snapshot->loop != LoopState::Off;
  const std::string hands_free_hint =
      context.hint("Every swing is found, answered and kept by itself", Command::HandsFree);
  const std::string measure_hint =
      context.hint("Stand still for a few seconds: the coach gets your body", Command::Measure);
  const std::string record_hint = context.hint("Keep the whole session as a film", Command::Record);
  const std::string mirror_hint =
      context.hint("Mirror the picture; what is kept stays as it is", Command::Mirror);
  ui.shadow(area, radius::kLarge, 14);
  Rect row = draw_card(ui, area, 9);
  const Button hands_free{.id = "hands-free",
                          .words = is_on ? "Stop hands-free" : "Start hands-free",
                          .icon = is_on ? Icon::Pause : Icon::Play,
                          .look = is_on ? ButtonLook::Plain : ButtonLook::Primary,
                          .hint = hands_free_hint};
  if (draw_button(ui, row.take_left(button_width(ui, hands_free), 8), hands_free)) {
    if (is_on)
      context.want(intent::DisarmHandsFree{});
    else
      context.want(intent::ArmHandsFree{});
  }
  const Button measure{.id = "measure",
                       .words = "Measure me",
                       .icon = Icon::Measure,
                       .look = ButtonLook::Quiet,
                       .hint = measure_hint};
  if (draw_button(ui, row.take_left(button_width(ui, measure), 4), measure))
    context.want(intent::MeasureBody{});
  const Button record{.id = "record",
                      .words = context.model.is_recording ? "Stop recording" : "Record",
                      .icon = Icon::Record,
                      .look = ButtonLook::Quiet,
                      .hint = record_hint,
                      .is_on = context.model.is_recording};
  if (draw_button(ui, row.take_left(button_width(ui, record), 4), record)) {
    if (context.model.is_recording)
      context.want(intent::StopRecording{});
    else
      context.want(intent::StartRecording{});
  }
  const Button mirror{.id = "mirror",
                      .icon = Icon::Mirror,
                      .look = ButtonLook::Quiet,
                      .hint = mirror_hint,
                      .is_on = context.state.is_mirrored};
  if (draw_button(ui, row.take_left(button_width(ui, mirror), 2), mirror))
    context.state.is_mirrored = !context.state.is_mirrored;
  const std::string golfer_hint = context.hint(
      context.state.frames_golfer ? "The whole picture" : "You as large as fits", Command::ToggleGolfer);
  const Button golfer{.id = "golfer",
                      .icon = Icon::Search,
                      .look = ButtonLook::Quiet,
                      .hint = golfer_hint,
                      .is_on = context.state.frames_golfer};
  if (draw_button(ui, row.take_left(button_width(ui, golfer), 2), golfer))
    context.state.frames_golfer = !context.state.frames_golfer;
  const std::string figures_hint = context.hint("Skeletons: both, yours, none", Command::ChangeFigures);
  const Button figures{.id = "figures",
                       .icon = Icon::Body,
                       .look = ButtonLook::Quiet,
                       .hint = figures_hint,
                       .is_on = context.state.figures != FigureShow::None};
  if (draw_button(ui, row.take_left(button_width(ui, figures), 12), figures)) change_figures(context.state);
  const double coach_width = std::min(230.0, std::max(120.0, row.width - 250));
  draw_coach_choice(context, row.take_right(coach_width, 10));
  if (row.width > 190) draw_pace(context, row.take_right(std::min(row.width, 300.0)));
}

void draw_replay(const PanelContext& context, const Rect& area) {
  if (!context.model.replay || !context.model.replay->review) return;
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  const ReviewSwing& review = *context.model.replay->review;
  const Analysis& analysis = review.analysis();
  Rect card = area;
  ui.shadow(card, radius::kLarge, 20);
  Rect inner = draw_card(ui, card, 22);
  Rect top = inner.take_top(112, 14);
  const Rect ring = top.take_left(112, 16);
  draw_score_ring(ui, ring.centre(), 54, analysis.score.percent, TextStyle::Display);
  ui.text_in(TextStyle::Heading, {top.x, top.y + 22, top.width, 34}, "Match", theme.text);
  ui.text_in(
      TextStyle::Body, {top.x, top.y + 56, top.width, 24},
      analysis.score.plus_minus >= 0.5 ? "± " + decimal(analysis.score.plus_minus, 0) + " of 100" : "of 100",
      theme.quiet);
  constexpr double kGood = 85;
  const bool is_good = analysis.score.percent >= kGood;
  const bool has_advice = !analysis.advice.empty() && analysis.advice.front().kind != AdviceKind::None;
  // Without its parts there is nothing to be said about them.
  const bool is_divided = has_advice || !analysis.student_events.empty();
  ui.text_in(TextStyle::Title, inner.take_top(26, 4),
             has_advice    ? "Change this first"
             : !is_divided ? "Only a score this time"
             : is_good     ? "Well done"
                           : "No one thing stands out",
             has_advice || !is_good || !is_divided ? theme.warning : theme.good);
  Rect bottom = inner.take_bottom(84);
  const std::string words = !is_divided               ? "Hold your address for a moment before you swing."
                            : analysis.advice.empty() ? "No clear difference was found."
                                                      : analysis.advice.front().text;
  // As large as it fits: to be read from where the golfer stands.
  TextStyle style = TextStyle::Display;
  for (const TextStyle smaller : {TextStyle::Heading, TextStyle::Title})
    if (ui.paragraph_height(style, inner.width, words) > inner.height) style = smaller;
  ui.paragraph(style, inner, words, theme.text,
               std::max(1, static_cast<int>(inner.height / ui.line_height(style))));
  const double used = ui.paragraph_height(style, inner.width, words) + 18;
  Rect others = {inner.x, inner.y + used, inner.width, inner.height - used};
  for (std::size_t i = 1; i < analysis.advice.size(); ++i) {
    const std::string then = "Then: " + analysis.advice[i].text;
    const double height = ui.paragraph_height(TextStyle::Title, others.width, then, 3);
    if (height > others.height) break;
    ui.paragraph(TextStyle::Title, others.take_top(height, 8), then, theme.quiet, 3);
  }
  Rect buttons = bottom.take_top(38, 12);
  const std::string review_words = context.hint("Review", Command::ReviewLast),
                    live_words = context.hint("Live", Command::Back);
  if (draw_button(ui, buttons.column(0, 2, 10),
                  {.id = "open", .words = review_words, .icon = Icon::Review, .look = ButtonLook::Primary}))
    context.want(intent::OpenLastSwing{});
  if (draw_button(ui, buttons.column(1, 2, 10), {.id = "leave", .words = live_words, .icon = Icon::Live}))
    context.want(intent::LeaveReplay{});
  ui.text_in(
      TextStyle::Caption, bottom,
      "Back to live in " +
          std::to_string(static_cast<int>(std::ceil(std::max(0.0, context.model.replay_seconds_left)))) +
          " s",
      theme.quiet, Align::Centre);
}

}  // namespace posecoach
