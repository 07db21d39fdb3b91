#include "ui/panels/common_panels.h"

#include <array>

#include "ui/widgets/controls.h"
#include "ui/widgets/sign.h"

namespace posecoach {
namespace {

constexpr double kMessageWidth = 420, kToastHeight = 52, kJobHeight = 58, kGap = 10, kEdge = 16;

void draw_place(const PanelContext& context, const Rect& area, ScreenName screen, Icon icon,
                std::string_view words, std::string_view hint) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  const Interaction on = ui.region(words, area);
  const bool is_here = context.state.screen == screen;
  if (is_here)
    ui.fill(area, chosen_paper(theme), radius::kMedium);
  else if (on.hovered)
    ui.fill(area, theme.raised, radius::kMedium);
  ui.focus_ring(area, radius::kMedium, on);
  const Colour ink = is_here ? theme.text : theme.quiet;
  draw_icon(ui, icon, {area.centre().x, area.y + 23}, 23,
            is_here ? mix(theme.accent, theme.text, 0.35F) : ink);
  ui.text_in(TextStyle::Caption, {area.x, area.bottom() - 24, area.width, 18}, words, ink, Align::Centre);
  ui.tooltip(area, on, hint);
  if (on.hovered) ui.use_hand_pointer();
  if (on.clicked) context.state.screen = screen;
}

Icon toast_icon(ToastKind kind) {
  return kind == ToastKind::Good      ? Icon::Check
         : kind == ToastKind::Warning ? Icon::Warning
                                      : Icon::Information;
}

void draw_toast(const PanelContext& context, const Rect& area, const Toast& toast) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  const IdScope scope(ui, "toast " + std::to_string(toast.id));
  ui.shadow(area, radius::kMedium, 14);
  ui.fill(area, mix(theme.surface, theme.raised, 0.5F).with_alpha(1), radius::kMedium);
  ui.outline(area, theme.line, radius::kMedium);
  Rect inner = area.inset(12, 0);
  const Colour colour = toast.kind == ToastKind::Good      ? theme.good
                        : toast.kind == ToastKind::Warning ? theme.warning
                                                           : theme.accent;
  draw_icon(ui, toast_icon(toast.kind), inner.take_left(20, 10).centre(), 19, colour);
  const Button close{.id = "close", .icon = Icon::Cross, .look = ButtonLook::Quiet};
  if (draw_button(ui, inner.take_right(30, 4).inset(0, 0.5 * (area.height - 30)), close))
    context.want(intent::DismissToast{toast.id});
  if (!toast.action.empty() && toast.intent) {
    const Button action{.id = "action", .words = toast.action};
    const double width = button_width(ui, action);
    if (draw_button(ui, inner.take_right(width, 8).inset(0, 0.5 * (area.height - 30)), action)) {
      context.want(*toast.intent);
      context.want(intent::DismissToast{toast.id});
    }
  }
  const double height = ui.paragraph_height(TextStyle::Body, inner.width, toast.text, 2);
  ui.paragraph(TextStyle::Body, {inner.x, area.centre().y - 0.5 * height, inner.width, height}, toast.text,
               theme.text, 2);
}

// What long work says of itself, for people.
std::string_view stage_words(std::string_view stage) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kWords = {
      {{"poses", "finding your joints"},
       {"retargeting", "carrying the coach over"},
       {"film", "writing the film"},
       {"filming", "writing the film"},
       {"waiting", "waiting its turn"}}};
  for (const auto& [said, words] : kWords)
    if (said == stage) return words;
  return stage;
}

void draw_job(const PanelContext& context, const Rect& area, const Job& job) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  const IdScope scope(ui, "job " + std::to_string(job.id));
  ui.shadow(area, radius::kMedium, 14);
  ui.fill(area, mix(theme.surface, theme.raised, 0.5F).with_alpha(1), radius::kMedium);
  ui.outline(area, theme.line, radius::kMedium);
  Rect inner = area.inset(14, 9);
  const Rect stop = inner.take_right(64, 12);
  if (draw_button(ui, stop.inset(0, 4), {.id = "cancel", .words = "Stop"}))
    context.want(intent::CancelJob{job.id});
  Rect words = inner.take_top(20);
  const double title = std::min(ui.text_width(TextStyle::Strong, job.title) + 8, words.width);
  ui.text_in(TextStyle::Strong, words.take_left(title), job.title, theme.text);
  ui.text_in(TextStyle::Caption, words, stage_words(job.stage), theme.quiet);
  draw_progress(ui, inner.take_bottom(6), job.fraction);
}

}  // namespace

void draw_rail(const PanelContext& context, const Rect& area) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  ui.fill(area, theme.surface);
  ui.fill({area.right() - 1, area.y, 1, area.height}, theme.line);
  Rect inner = area.inset(8, 12);
  draw_sign(ui, inner.take_top(44, 12).centre(), 44);
  struct Place {
    ScreenName screen;
    Icon icon;
    std::string_view words, hint;
    Command command;
  };
  constexpr std::array<Place, 4> kPlaces = {
      {{ScreenName::Live, Icon::Live, "Live", "Practise", Command::ShowLive},
       {ScreenName::Review, Icon::Review, "Review", "Look closely", Command::ShowReview},
       {ScreenName::Library, Icon::Library, "Library", "Kept swings", Command::ShowLibrary},
       {ScreenName::SetUp, Icon::SetUp, "Set-up", "Camera, you, coach", Command::ShowSetUp}}};
  for (const Place& place : kPlaces)
    draw_place(context, inner.take_top(62, 6), place.screen, place.icon, place.words,
               context.hint(place.hint, place.command));
  const Rect keys = inner.take_bottom(52, 6);
  const Interaction on = ui.region("keys", keys);
  if (on.hovered) ui.fill(keys, theme.raised, radius::kMedium);
  ui.focus_ring(keys, radius::kMedium, on);
  draw_icon(ui, Icon::Keyboard, {keys.centre().x, keys.y + 19}, 21, theme.quiet);
  ui.text_in(TextStyle::Caption, {keys.x, keys.bottom() - 22, keys.width, 18}, "Keys", theme.quiet,
             Align::Centre);
  ui.tooltip(keys, on, context.hint("All keys", Command::ShowKeys));
  if (on.hovered) ui.use_hand_pointer();
  if (on.clicked) context.state.shows_keys = true;
}

Rect messages_area(const WindowModel& model, const Rect& area) {
  const double height = 2 * kEdge + static_cast<double>(model.jobs.size()) * (kJobHeight + kGap) +
                        static_cast<double>(model.toasts.size()) * (kToastHeight + kGap);
  Rect rest = area;
  return rest.take_bottom(height).take_right(kMessageWidth + 2 * kEdge);
}

void draw_messages(const PanelContext& context, const Rect& area) {
  const double width = std::min(kMessageWidth, area.width - 24);
  double y = area.bottom() - kEdge;
  const double x = area.right() - width - kEdge;
  // The newest are the lowest; what does not fit waits.
  for (auto job = context.model.jobs.rbegin(); job != context.model.jobs.rend() && y - kJobHeight > area.y;
       ++job) {
    y -= kJobHeight;
    draw_job(context, {x, y, width, kJobHeight}, *job);
    y -= kGap;
  }
  for (auto toast = context.model.toasts.rbegin();
       toast != context.model.toasts.rend() && y - kToastHeight > area.y; ++toast) {
    y -= kToastHeight;
    draw_toast(context, {x, y, width, kToastHeight}, *toast);
    y -= kGap;
  }
}

void draw_export_menu(const PanelContext& context, const Rect& area, const std::string& swing_id) {
  struct Entry {
    ExportKind kind;
    Choice choice;
  };
  static const std::array<Entry, 6> kEntries = {
      {{ExportKind::OverlayFilm, {"Film with both skeletons", "MP4"}},
       {ExportKind::DrawnFilm, {"The same with what you drew", "MP4; each drawing stays for half a second"}},
       {ExportKind::Report, {"Report", "HTML page, for any browser"}},
       {ExportKind::Csv, {"Joint positions", "CSV table"}},
       {ExportKind::Bvh, {"Motion", "BVH, for animation programs"}},
       {ExportKind::Trc, {"Markers", "TRC, for OpenSim"}}}};
  std::array<Choice, kEntries.size()> choices;
  for (std::size_t i = 0; i < kEntries.size(); ++i) choices[i] = kEntries[i].choice;
  const int picked = draw_dropdown(context.ui, "export", area, "Export", choices, -1, Icon::Export);
  if (picked >= 0)
    context.want(intent::ExportSwing{swing_id, kEntries[static_cast<std::size_t>(picked)].kind});
}

}  // namespace posecoach
