#include <array>
#include <cmath>

#include "core/base/index.h"
#include "ui/panels/common_panels.h"
#include "ui/panels/review_events.h"
#include "ui/panels/review_panels.h"
#include "ui/render/words.h"
#include "ui/widgets/controls.h"

namespace posecoach {
namespace {

constexpr double kPad = 14;

std::string event_words(const Analysis& analysis, int picture) {
  const std::string phase = student_phase(analysis, picture);
  return phase.empty() ? "Picture " + std::to_string(picture + 1) : phase;
}

// The unit stands behind the value.
std::string metric_title(const Metric& metric) {
  std::string_view name = metric.name;
  const std::string suffix = "_" + (metric.unit == "%" ? "percent" : metric.unit);
  if (!metric.unit.empty() && name.ends_with(suffix)) name.remove_suffix(suffix.size());
  for (const std::string_view event : {"_address", "_top", "_impact"})
    if (name.ends_with(event))
      return title_from_name(name.substr(0, name.size() - event.size())) + " at " +
             std::string(event.substr(1));
  return title_from_name(name);
}

std::string unit_words(const std::string& unit) {
  return unit == "deg" ? "°" : unit.empty() ? "" : " " + unit;
}

bool is_without_advice(const Analysis& analysis) {
  return std::all_of(analysis.advice.begin(), analysis.advice.end(),
                     [](const Advice& advice) { return advice.kind == AdviceKind::None; });
}

double row_height(const Ui& ui, const Advice& advice, double width) {
  return 10 + 16 + ui.paragraph_height(TextStyle::Body, width - 52, advice.text, 4) + 10;
}

void draw_advice_row(const PanelContext& context, const Rect& row, int number) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  const Analysis& analysis = context.model.opened->review->analysis();
  const Advice& advice = analysis.advice[index(number)];
  const Interaction on = ui.region("advice " + std::to_string(number), row);
  const bool is_chosen = context.state.chosen_advice == number;
  if (is_chosen)
    ui.fill(row, chosen_paper(theme), radius::kMedium);
  else if (on.hovered)
    ui.fill(row, theme.raised, radius::kMedium);
  ui.focus_ring(row, radius::kMedium, on);
  Rect inner = row.inset(10);
  const Rect sign = inner.take_left(24, 8);
  const bool is_none = advice.kind == AdviceKind::None;
  const Vec2 at(sign.centre().x, sign.y + 12);
  ui.disc(at, 12, is_none ? theme.good : number == 0 ? theme.warning : theme.hovered);
  const Colour ink = is_none || number == 0
                         ? colour_from_hex(theme.kind == ThemeKind::Dark ? 0x0B0F14 : 0xFFFFFF)
                         : theme.text;
  if (is_none)
    draw_icon(ui, Icon::Check, at, 15, ink);
  else
    ui.text(TextStyle::Strong, {at.x, at.y + 0.5 * ui.cap_height(TextStyle::Strong)},
            std::to_string(number + 1), ink, Align::Centre);
  const std::string_view kind = advice.kind == AdviceKind::Timing ? "Tempo" : is_none ? "" : "Position";
  if (!is_none)
    ui.text_in(TextStyle::Caption, inner.take_top(16),
               std::string(kind) + " · " + event_words(analysis, advice.student_frame), theme.quiet);
  ui.paragraph(TextStyle::Body, inner, advice.text, theme.text, 4);
  if (on.hovered) ui.use_hand_pointer();
  if (on.clicked) show_advice(context, number);
}

void draw_score(const PanelContext& context, Rect area) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  const Analysis& analysis = context.model.opened->review->analysis();
  const Rect ring = area.take_left(72, 14);
  draw_score_ring(ui, ring.centre(), 35, analysis.score.percent, TextStyle::Heading);
  Rect words = area.inset(0, 6);
  ui.text_in(TextStyle::Title, words.take_top(24), "Match", theme.text);
  ui.text_in(TextStyle::Caption, words.take_top(18),
             decimal(analysis.score.mean_joint_error_m * 100, 1) + " cm apart on average", theme.quiet);
  ui.text_in(TextStyle::Caption, words.take_top(18),
             "Raw " + decimal(analysis.score.raw, 1) + ", lower is better", theme.faint);
}

// The moment's own distance, so that the number moves with the film.
void draw_moment(const PanelContext& context, Rect area) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  const ReviewSwing& review = *context.model.opened->review;
  const int picture = shown_picture(context);
  const auto& apart = review.apart_m;
  const bool is_known = picture >= 0 && picture < static_cast<int>(apart.size()) && apart[index(picture)];
  ui.fill({area.x, area.y, area.width, 1}, theme.line);
  area.take_top(1, 9);
  Rect first = area.take_top(20);
  ui.text_in(TextStyle::Caption, first.take_left(0.5 * area.width), "Now apart", theme.quiet);
  ui.text_in(TextStyle::Strong, first,
             is_known ? decimal(*apart[index(picture)] * 100, 1) + " cm" : std::string("–"), theme.text,
             Align::Right);
  struct Row {
    std::string name, value;
  };
  std::vector<Row> rows;
  for (const Metric& metric : review.analysis().metrics) {
    if (!metric.available) continue;
    std::string value = decimal(metric.value, 1) + unit_words(metric.unit);
    if (metric.coach) value += "  (coach " + decimal(*metric.coach, 1) + ")";
    rows.push_back({metric_title(metric), value});
  }
  for (const Row& row : rows) {
    if (area.height < 20) return;
    Rect line = area.take_top(20);
    const double value_width = std::min(ui.text_width(TextStyle::Caption, row.value) + 1, 0.6 * line.width);
    const Rect value = line.take_right(value_width, 6);
    ui.text_in(TextStyle::Caption, line, row.name, theme.quiet);
    ui.text_in(TextStyle::Caption, value, row.value, theme.text, Align::Right);
  }
}

}  // namespace

void show_advice(const PanelContext& context, int number) {
  const ReviewSwing& review = *context.model.opened->review;
  const auto& advice = review.analysis().advice;
  if (number < 0 || number >= static_cast<int>(advice.size())) return;
  context.state.chosen_advice = number;
  if (advice[index(number)].kind == AdviceKind::None) return;
  context.state.playback =
      moved_to(context.state.playback, advice[index(number)].student_frame, marks_of(review));
}

void draw_advice(const PanelContext& context, const Rect& area) {
  if (!context.model.opened) return;
  Ui& ui = context.ui;
  const Analysis& analysis = context.model.opened->review->analysis();
  Rect inner = draw_card(ui, area, kPad);
  draw_score(context, inner.take_top(74, 10));
  if (analysis.student_events.empty() && is_without_advice(analysis)) {
    ui.text_in(TextStyle::Title, inner.take_top(24, 4), "Only a score this time", context.theme().text);
    constexpr std::string_view kWhy =
        "The parts of the swing could not be told apart. Hold your address for a moment before you swing.";
    const double height = ui.paragraph_height(TextStyle::Body, inner.width, kWhy, 5);
    ui.paragraph(TextStyle::Body, inner.take_top(height, 14), kWhy, context.theme().quiet, 5);
    if (inner.height >= 30) draw_moment(context, inner);
    return;
  }
  const bool is_alone = analysis.advice.size() == 1 && analysis.advice[0].kind == AdviceKind::None;
  ui.text_in(TextStyle::Title, inner.take_top(24, 4), is_alone ? "No one thing stands out" : "What to change",
             context.theme().text);
  double wanted = 0;
  for (const Advice& advice : analysis.advice) wanted += row_height(ui, advice, inner.width + 12) + 4;
  constexpr double kMoment = 38;  // the advice comes before the numbers
  const Rect list = {inner.x - 6, inner.y, inner.width + 12,
                     std::min(wanted, std::max(60.0, inner.height - kMoment))};
  const Rect content = ui.begin_scroll("advice", list, wanted);
  double y = content.y;
  for (int i = 0; i < static_cast<int>(analysis.advice.size()); ++i) {
    const double height = row_height(ui, analysis.advice[index(i)], content.width);
    draw_advice_row(context, {content.x, y, content.width, height}, i);
    y += height + 4;
  }
  ui.end_scroll();
  inner.take_top(list.height + 8);
  if (inner.height >= 30) draw_moment(context, inner);
}

void draw_review_header(const PanelContext& context, const Rect& area) {
  if (!context.model.opened) return;
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  const WindowModel& model = context.model;
  const OpenedSwing& swing = *model.opened;
  Rect row = area;
  const auto place = [&](const Button& button) { return row.take_right(button_width(ui, button), 6); };
  draw_export_menu(context, row.take_right(118, 6), swing.id);
  const Button reference{.id = "reference",
                         .words = "Make coach",
                         .icon = Icon::Coach,
                         .look = ButtonLook::Quiet,
                         .hint = "Compare later swings with this one"};
  if (draw_button(ui, place(reference), reference)) context.want(intent::MakeReference{swing.id});
  if (model.compared) {
    constexpr std::array<std::string_view, 2> kLooks = {"Side by side", "In one"};
    const int look = draw_segments(ui, "compare look", row.take_right(224, 6), kLooks,
                                   static_cast<int>(context.state.compare));
    context.state.compare = static_cast<CompareLook>(look);
    const Button stop{
        .id = "stop comparing", .icon = Icon::Cross, .look = ButtonLook::Quiet, .hint = "One swing only"};
    if (draw_button(ui, place(stop), stop)) context.want(intent::StopComparing{});
  } else {
    const std::string compare_hint = context.hint("Choose a second swing", Command::SideBySide);
    const Button compare{.id = "compare",
                         .words = "Compare",
                         .icon = Icon::SideBySide,
                         .look = ButtonLook::Quiet,
                         .hint = compare_hint};
    if (draw_button(ui, place(compare), compare)) {
      context.state.is_picking_second = true;
      context.state.screen = ScreenName::Library;
    }
  }
  if (!swing.marks.events.empty()) {
    const Button found{.id = "found positions",
                       .words = "Positions as found",
                       .icon = Icon::Undo,
                       .look = ButtonLook::Quiet,
                       .hint = "What you moved by hand goes back"};
    if (draw_button(ui, place(found), found)) put_events_back(context);
  }
  const std::string star_hint = context.hint("Star", Command::ToggleStar);
  const Button star{.id = "star",
                    .icon = swing.is_starred ? Icon::StarFilled : Icon::Star,
                    .look = ButtonLook::Quiet,
                    .hint = star_hint,
                    .is_on = swing.is_starred};
  if (draw_button(ui, place(star), star)) context.want(intent::SetStar{swing.id, !swing.is_starred});
  const double title = std::min(ui.text_width(TextStyle::Title, swing.title) + 14, row.width);
  ui.text_in(TextStyle::Title, row.take_left(title), swing.title, theme.text);
  ui.text_in(TextStyle::Body, row, swing.detail, theme.quiet);
}

}  // namespace posecoach
