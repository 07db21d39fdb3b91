#include "ui/panels/common_panels.h"

#include <array>

#include "ui/screens/key_map.h"
#include "ui/widgets/controls.h"

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
  ui.text_in(TextStyle::Caption, words, job.stage, theme.quiet);
  draw_progress(ui, inner.take_bottom(6), job.fraction);
}

}  // namespace

void draw_rail(const PanelContext& context, const Rect& area) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  ui.fill(area, theme.surface);
  ui.fill({area.right() - 1, area.y, 1, area.height}, theme.line);
  Rect inner = area.inset(8, 12);
  // The program's sign: the two bodies of its one idea.
  const Rect sign = inner.take_top(40, 14);
  ui.disc(sign.centre() + Vec2(-5, 0), 13, theme.coach);
  ui.disc(sign.centre() + Vec2(5, 0), 13, theme.student.with_alpha(0.9F));
  struct Place {
    ScreenName screen;
    Icon icon;
    std::string_view words, hint;
  };
  constexpr std::array<Place, 4> kPlaces = {
      {{ScreenName::Live, Icon::Live, "Live", "Practise (Ctrl+1)"},
       {ScreenName::Review, Icon::Review, "Review", "Look closely (Ctrl+2)"},
       {ScreenName::Library, Icon::Library, "Library", "Kept swings (Ctrl+3)"},
       {ScreenName::SetUp, Icon::SetUp, "Set-up", "Camera, you, coach (Ctrl+4)"}}};
  for (const Place& place : kPlaces)
    draw_place(context, inner.take_top(62, 6), place.screen, place.icon, place.words, place.hint);
  const Rect keys = inner.take_bottom(52, 6);
  const Interaction on = ui.region("keys", keys);
  if (on.hovered) ui.fill(keys, theme.raised, radius::kMedium);
  ui.focus_ring(keys, radius::kMedium, on);
  draw_icon(ui, Icon::Keyboard, {keys.centre().x, keys.y + 19}, 21, theme.quiet);
  ui.text_in(TextStyle::Caption, {keys.x, keys.bottom() - 22, keys.width, 18}, "F1", theme.quiet,
             Align::Centre);
  ui.tooltip(keys, on, "All keys (F1)");
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
  static const std::array<Entry, 5> kEntries = {
      {{ExportKind::OverlayFilm, {"Film with both skeletons", "MP4"}},
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

void draw_key_sheet(const PanelContext& context, const Rect& area) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  ui.fill(area, theme.scrim);
  const double width = std::min(1060.0, area.width - 32), height = std::min(640.0, area.height - 32);
  const Rect card{area.centre().x - 0.5 * width, area.centre().y - 0.5 * height, width, height};
  ui.shadow(card, radius::kLarge, 24);
  Rect inner = draw_card(ui, card, 26);
  Rect heading = inner.take_top(34, 14);
  if (draw_button(ui, heading.take_right(36),
                  {.id = "close keys", .icon = Icon::Cross, .look = ButtonLook::Quiet}))
    context.state.shows_keys = false;
  ui.text_in(TextStyle::Heading, heading, "Keys", theme.text);
  constexpr double kLine = 23;
  constexpr std::array<std::array<KeyGroup, 2>, 3> kColumns = {{{KeyGroup::Everywhere, KeyGroup::Live},
                                                                {KeyGroup::Player, KeyGroup::Player},
                                                                {KeyGroup::Review, KeyGroup::Library}}};
  for (int c = 0; c < 3; ++c) {
    Rect column = inner.column(c, 3, 34);
    const auto& groups = kColumns[static_cast<std::size_t>(c)];
    for (std::size_t g = 0; g < (groups[0] == groups[1] ? 1U : 2U); ++g) {
      ui.text_in(TextStyle::Strong, column.take_top(26), title_of(groups[g]), theme.accent);
      for (const KeyBinding& binding : key_bindings()) {
        if (binding.group != groups[g] || column.height < kLine) continue;
        Rect row = column.take_top(kLine);
        std::string keys = to_words(binding.first);
        if (binding.second.key != Key::None) keys += "  or  " + to_words(binding.second);
        ui.text_in(TextStyle::Body, row.take_left(0.5 * row.width, 8), binding.words, theme.text);
        ui.text_in(TextStyle::Body, row, keys, theme.quiet);
      }
      if (groups[g] == KeyGroup::Player && column.height >= kLine) {
        Rect row = column.take_top(kLine);
        ui.text_in(TextStyle::Body, row.take_left(0.5 * row.width, 8), "Go to a position", theme.text);
        ui.text_in(TextStyle::Body, row, "1 to 8", theme.quiet);
      }
      column.take_top(14);
    }
    if (c == 2) {
      ui.text_in(TextStyle::Strong, column.take_top(26), "Without a mouse", theme.accent);
      ui.paragraph(TextStyle::Body, column,
                   "Tab and Shift+Tab go from button to button, Enter presses. While you write, keys go into "
                   "the text.",
                   theme.quiet, 4);
    }
  }
}

void draw_import_dialog(const PanelContext& context, const Rect& area) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  ui.fill(area, theme.scrim);
  const double width = std::min(560.0, area.width - 32), height = 218;
  const Rect card{area.centre().x - 0.5 * width, area.centre().y - 0.5 * height, width, height};
  ui.shadow(card, radius::kLarge, 24);
  Rect inner = draw_card(ui, card, 24);
  ui.text_in(TextStyle::Heading, inner.take_top(32, 8), "Import a film", theme.text);
  ui.paragraph(TextStyle::Body, inner.take_top(22, 10), "Write where it is, or drop it on the window.",
               theme.quiet, 1);
  ui.text_field("import path", inner.take_top(38, 18), context.state.typed_import,
                "/home/you/Videos/swing.mp4");
  Rect row = inner.take_top(38);
  const bool is_ready = !context.state.typed_import.empty();
  const bool is_entered = is_ready && ui.take_key({Key::Enter});
  if (draw_button(
          ui, row.take_right(120, 10),
          {.id = "import now", .words = "Import", .look = ButtonLook::Primary, .is_enabled = is_ready}) ||
      is_entered) {
    context.want(intent::ImportFile{context.state.typed_import});
    context.state.typed_import.clear();
    ui.close_popup();
  }
  if (draw_button(ui, row.take_right(100), {.id = "import not", .words = "Cancel"})) ui.close_popup();
}

}  // namespace posecoach
