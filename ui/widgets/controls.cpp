#include "ui/widgets/controls.h"

#include <array>
#include <cmath>

#include "ui/render/words.h"

namespace posecoach {
namespace {

constexpr double kIcon = 18;

Colour transparent() {
  return {0, 0, 0, 0};
}

struct Inks {
  Colour paper, ink;
};

Inks button_inks(const Theme& theme, const Button& button, const Interaction& on) {
  const bool is_primary = button.look == ButtonLook::Primary;
  Colour paper = is_primary ? theme.accent : button.look == ButtonLook::Quiet ? transparent() : theme.raised;
  Colour ink = is_primary ? theme.on_accent : theme.text;
  if (button.is_on && !is_primary) {
    paper = chosen_paper(theme);
    ink = mix(theme.accent, theme.text, 0.35F);
  }
  if (button.is_enabled && on.held)
    paper = is_primary ? mix(theme.accent, theme.text, 0.25F) : theme.pressed;
  else if (button.is_enabled && on.hovered)
    paper = is_primary ? mix(theme.accent, theme.text, 0.12F) : theme.hovered;
  if (!button.is_enabled) {
    ink = theme.faint.with_alpha(0.6F);
    if (is_primary) paper = theme.raised;
  }
  return {paper, ink};
}

}  // namespace

double button_width(const Ui& ui, const Button& button) {
  double width = 2 * space::kMedium;
  if (button.icon != Icon::None) width += kIcon;
  if (!button.words.empty()) width += ui.text_width(TextStyle::Strong, button.words) + 4;
  if (button.icon != Icon::None && !button.words.empty()) width += space::kSmall - 2;
  return std::ceil(width);
}

bool draw_button(Ui& ui, const Rect& rect, const Button& button) {
  const Interaction on = ui.region(button.id, rect, button.is_enabled ? Focus::ByKeyboard : Focus::Never);
  const Inks inks = button_inks(ui.theme(), button, on);
  const double corner = std::min(radius::kMedium, 0.5 * rect.height);
  ui.fill(rect, inks.paper, corner);
  ui.focus_ring(rect, corner, on);
  double content = button.words.empty() ? 0 : ui.text_width(TextStyle::Strong, button.words);
  const bool has_icon = button.icon != Icon::None;
  const double gap = has_icon && !button.words.empty() ? space::kSmall - 1 : 0;
  content += gap + (has_icon ? kIcon : 0);
  double x = rect.centre().x - 0.5 * std::min(content, rect.width - space::kSmall);
  if (has_icon) {
    draw_icon(ui, button.icon, {x + 0.5 * kIcon, rect.centre().y}, kIcon, inks.ink);
    x += kIcon + gap;
  }
  if (!button.words.empty())
    ui.text_in(TextStyle::Strong, {x, rect.y, rect.right() - x - 4, rect.height}, button.words, inks.ink);
  if (button.is_enabled && on.hovered) ui.use_hand_pointer();
  ui.tooltip(rect, on, button.hint);
  return button.is_enabled && on.clicked;
}

int draw_segments(Ui& ui, std::string_view id, const Rect& rect, std::span<const std::string_view> words,
                  int chosen) {
  const IdScope scope(ui, id);
  const Theme& theme = ui.theme();
  const double corner = std::min(radius::kMedium, 0.5 * rect.height);
  ui.fill(rect, theme.raised, corner);
  const int count = static_cast<int>(words.size());
  for (int i = 0; i < count; ++i) {
    const Rect part = rect.column(i, count, 0);
    const std::string_view label = words[static_cast<std::size_t>(i)];
    const Interaction on = ui.region(label, part);
    const bool is_chosen = i == chosen;
    if (is_chosen)
      ui.fill(part.inset(3), chosen_paper(theme), corner - 3);
    else if (on.hovered)
      ui.fill(part.inset(3), theme.hovered, corner - 3);
    const Colour ink = is_chosen ? mix(theme.accent, theme.text, 0.35F) : theme.quiet;
    ui.text_in(TextStyle::Strong, part.inset(6, 0), label, ink, Align::Centre);
    ui.focus_ring(part.inset(3), corner - 3, on);
    if (on.hovered) ui.use_hand_pointer();
    if (on.clicked) chosen = i;
  }
  return chosen;
}

bool draw_switch(Ui& ui, std::string_view id, const Rect& rect, std::string_view words, bool is_on) {
  const Theme& theme = ui.theme();
  const Interaction on = ui.region(id, rect);
  if (on.clicked) is_on = !is_on;
  const Rect track{rect.right() - 38, rect.centre().y - 11, 38, 22};
  ui.text_in(TextStyle::Body, {rect.x, rect.y, rect.width - 50, rect.height}, words, theme.text);
  ui.fill(track, is_on ? theme.accent : theme.hovered, 11);
  ui.disc({is_on ? track.right() - 11 : track.x + 11, track.centre().y}, 8,
          is_on ? theme.on_accent : theme.quiet);
  ui.focus_ring(track, 11, on);
  if (on.hovered) ui.use_hand_pointer();
  return is_on;
}

double pill_width(const Ui& ui, const Pill& pill) {
  return std::ceil(ui.text_width(TextStyle::Caption, pill.words) + 2 * 9 +
                   (pill.icon == Icon::None ? 0 : 17));
}

void draw_pill(Ui& ui, const Rect& rect, const Pill& pill) {
  ui.fill(rect, pill.paper, 0.5 * rect.height);
  Rect inner = rect.inset(9, 0);
  if (pill.icon != Icon::None) {
    draw_icon(ui, pill.icon, {inner.x + 6, rect.centre().y}, 14, pill.ink);
    inner.take_left(17);
  }
  ui.text_in(TextStyle::Caption, inner, pill.words, pill.ink);
}

int draw_dropdown(Ui& ui, std::string_view id, const Rect& rect, std::string_view shown,
                  std::span<const Choice> choices, int chosen, Icon icon) {
  const IdScope scope(ui, id);
  const Theme& theme = ui.theme();
  const Interaction on = ui.region("field", rect);
  ui.fill(rect, on.hovered ? theme.hovered : theme.raised, radius::kSmall);
  ui.outline(rect, theme.line, radius::kSmall);
  ui.focus_ring(rect, radius::kSmall, on);
  Rect inner = rect.inset(space::kMedium, 0);
  if (icon != Icon::None) draw_icon(ui, icon, inner.take_left(16, space::kSmall).centre(), 16, theme.quiet);
  draw_icon(ui, Icon::ArrowDown, inner.take_right(14, space::kTiny).centre(), 14, theme.quiet);
  ui.text_in(TextStyle::Body, inner, shown, theme.text);
  if (on.hovered) ui.use_hand_pointer();
  const std::string popup = "dropdown " + std::string(id);
  if (on.clicked) {
    ui.open(popup);
    if (on.focused) ui.focus_on("choice " + std::to_string(std::max(0, chosen)));
  }
  if (!ui.is_open(popup)) return -1;

  constexpr double kRow = 46, kPlainRow = 36;
  const bool has_details = std::any_of(choices.begin(), choices.end(),
                                       [](const Choice& choice) { return !choice.detail.empty(); });
  const double row = has_details ? kRow : kPlainRow;
  const double height = std::min(row * static_cast<double>(choices.size()) + 12, 0.7 * ui.whole().height);
  double wide = std::max(rect.width, 200.0);
  for (const Choice& choice : choices)
    wide = std::max({wide, ui.text_width(TextStyle::Strong, choice.title) + 58,
                     ui.text_width(TextStyle::Caption, choice.detail) + 58});
  Rect list{rect.x, rect.bottom() + 4, std::min(wide, std::max(rect.width, 420.0)), height};
  if (list.bottom() > ui.whole().height - 8) list.y = std::max(8.0, rect.y - height - 4);
  list.x = std::min(list.x, ui.whole().width - list.width - 8);
  int picked = -1;
  ui.begin_layer(popup, ui.whole());
  const Interaction outside = ui.region("outside", ui.whole(), Focus::Never);
  ui.shadow(list, radius::kMedium, 18);
  ui.fill(list, mix(theme.surface, theme.raised, 0.4F).with_alpha(1), radius::kMedium);
  ui.outline(list, theme.line, radius::kMedium);
  const Rect area = list.inset(6);
  const Rect content = ui.begin_scroll("list", area, row * static_cast<double>(choices.size()));
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const Rect item{content.x, content.y + row * static_cast<double>(i), content.width, row};
    const Interaction over = ui.region("choice " + std::to_string(i), item);
    if (over.hovered || over.focused) ui.fill(item, theme.hovered, radius::kSmall);
    const bool has_detail = !choices[i].detail.empty();
    Rect words = item.inset(10, has_detail ? 5 : 0);
    if (static_cast<int>(i) == chosen)
      draw_icon(ui, Icon::Check, words.take_right(16, 4).centre(), 16, theme.accent);
    if (has_detail) {
      ui.text_in(TextStyle::Strong, words.take_top(0.5 * words.height), choices[i].title, theme.text);
      ui.text_in(TextStyle::Caption, words, choices[i].detail, theme.quiet);
    } else {
      ui.text_in(has_details ? TextStyle::Strong : TextStyle::Body, words, choices[i].title, theme.text);
    }
    if (over.clicked) picked = static_cast<int>(i);
  }
  ui.end_scroll();
  const bool is_outside = outside.clicked && !list.contains(outside.mouse);
  if (picked >= 0 || is_outside || ui.take_key({Key::Escape})) ui.close_popup();
  ui.end_layer();
  return picked;
}

Rect draw_card(Ui& ui, const Rect& rect, double padding) {
  ui.fill(rect, ui.theme().surface, radius::kLarge);
  ui.outline(rect, ui.theme().line, radius::kLarge);
  return rect.inset(padding);
}

Rect draw_titled_card(Ui& ui, const Rect& rect, std::string_view title, Icon icon) {
  Rect inner = draw_card(ui, rect);
  Rect heading = inner.take_top(22, space::kMedium);
  if (icon != Icon::None)
    draw_icon(ui, icon, heading.take_left(20, space::kSmall).centre(), 19, ui.theme().quiet);
  ui.text_in(TextStyle::Title, heading, title, ui.theme().text);
  return inner;
}

void draw_progress(Ui& ui, const Rect& rect, double fraction) {
  const Theme& theme = ui.theme();
  ui.fill(rect, theme.hovered, 0.5 * rect.height);
  Rect bar = rect;
  if (fraction >= 0) {
    bar.width = std::max(rect.height, rect.width * std::min(1.0, fraction));
  } else {
    bar.width = 0.3 * rect.width;
    bar.x += 0.7 * rect.width * (0.5 - 0.5 * std::cos(3 * ui.time_s()));
  }
  ui.fill(bar, theme.accent, 0.5 * rect.height);
}

Colour chosen_paper(const Theme& theme) {
  // Over a film what is raised is only a veil.
  if (theme.raised.alpha < 1) return theme.accent.with_alpha(0.34F);
  return mix(theme.raised, theme.accent, 0.28F);
}

Colour score_colour(const Theme& theme, double percent) {
  const auto p = static_cast<float>(percent);
  return p < 60 ? mix(theme.bad, theme.warning, std::clamp((p - 30) / 30, 0.0F, 1.0F))
                : mix(theme.warning, theme.good, std::clamp((p - 60) / 30, 0.0F, 1.0F));
}

void draw_score_ring(Ui& ui, const Vec2& centre, double radius, double percent, TextStyle style) {
  const double shown = std::clamp(percent, 0.0, 100.0), width = std::max(4.0, 0.16 * radius);
  ui.ring(centre, radius - 0.5 * width, ui.theme().hovered, width);
  if (shown > 0.5)
    ui.arc(centre, radius - 0.5 * width, 0, 2 * kPi * shown / 100, score_colour(ui.theme(), shown), width);
  ui.text(style, {centre.x, centre.y + 0.5 * ui.cap_height(style)}, decimal(std::round(shown), 0),
          ui.theme().text, Align::Centre);
}

void draw_empty(Ui& ui, const Rect& rect, Icon icon, std::string_view title, std::string_view words) {
  const Theme& theme = ui.theme();
  const double width = std::min(420.0, rect.width - 2 * space::kLarge);
  const double below = ui.paragraph_height(TextStyle::Body, width, words, 4);
  constexpr double kDisc = 76;
  const double height = kDisc + space::kLarge + 28 + below;
  Rect area{rect.centre().x - 0.5 * width, rect.centre().y - 0.5 * height, width, height};
  const Vec2 at = area.take_top(kDisc, space::kLarge).centre();
  ui.disc(at, 0.5 * kDisc, mix(theme.surface, theme.raised, 0.7F));
  draw_icon(ui, icon, at, 36, mix(theme.accent, theme.quiet, 0.4F));
  ui.text_in(TextStyle::Title, area.take_top(28), title, theme.text, Align::Centre);
  ui.paragraph(TextStyle::Body, area, words, theme.quiet, 4, Align::Centre);
}

}  // namespace posecoach
