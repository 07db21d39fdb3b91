#include "ui/theme/theme.h"

#include <algorithm>
#include <cmath>

namespace posecoach {
namespace {

void set_people(Theme& theme) {
  theme.student = student_style(theme.palette).bone;
  theme.coach = coach_style(theme.palette).bone;
  const bool is_dark = theme.kind == ThemeKind::Dark;
  const Colour towards = colour_from_hex(is_dark ? 0xFFFFFF : 0x000000);
  theme.student_text = mix(theme.student, towards, is_dark ? 0.30F : 0.48F);
  theme.coach_text = mix(theme.coach, towards, is_dark ? 0.34F : 0.38F);
}

// Green against amber against red differ in brightness too; for colour-blind eyes blue takes green's place.
void set_levels(Theme& theme) {
  const bool is_dark = theme.kind == ThemeKind::Dark, is_safe = theme.palette == Palette::ColourBlindSafe;
  theme.good = colour_from_hex(is_safe ? (is_dark ? 0x58B0FF : 0x1565B8) : (is_dark ? 0x3DD68C : 0x147A48));
  theme.warning = colour_from_hex(is_dark ? 0xFFC247 : 0x8A5A00);
  theme.bad = colour_from_hex(is_safe ? (is_dark ? 0xFF9A62 : 0xB3470B) : (is_dark ? 0xFF7A70 : 0xC02B22));
}

Theme dark() {
  Theme theme;
  theme.background = colour_from_hex(0x0E1217);
  theme.surface = colour_from_hex(0x171D25);
  theme.raised = colour_from_hex(0x242D38);
  theme.hovered = colour_from_hex(0x2E3947);
  theme.pressed = colour_from_hex(0x1E2630);
  theme.line = colour_from_hex(0x2C3642);
  theme.text = colour_from_hex(0xF3F6FA);
  theme.quiet = colour_from_hex(0xA9B5C4);
  theme.faint = colour_from_hex(0x7F8C9C);
  theme.accent = colour_from_hex(0x8AB8FF);
  theme.on_accent = colour_from_hex(0x0B1626);
  theme.scrim = colour_from_hex(0x05080C).with_alpha(0.72F);
  theme.shadow = colour_from_hex(0x000000).with_alpha(0.40F);
  return theme;
}

Theme light() {
  Theme theme;
  theme.kind = ThemeKind::Light;
  theme.background = colour_from_hex(0xEEF1F5);
  theme.surface = colour_from_hex(0xFFFFFF);
  theme.raised = colour_from_hex(0xE9EDF2);
  theme.hovered = colour_from_hex(0xDDE3EA);
  theme.pressed = colour_from_hex(0xCFD7E1);
  theme.line = colour_from_hex(0xD5DCE5);
  theme.text = colour_from_hex(0x151B23);
  theme.quiet = colour_from_hex(0x4D5A6A);
  theme.faint = colour_from_hex(0x697788);
  theme.accent = colour_from_hex(0x1F5FBF);
  theme.on_accent = colour_from_hex(0xFFFFFF);
  theme.scrim = colour_from_hex(0x1A222C).with_alpha(0.55F);
  theme.shadow = colour_from_hex(0x1A222C).with_alpha(0.16F);
  return theme;
}

double luminance(const Colour& colour) {
  const auto linear = [](float channel) {
    const double c = static_cast<double>(channel);
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
}

}  // namespace

Theme make_theme(ThemeKind kind, Palette palette) {
  Theme theme = kind == ThemeKind::Dark ? dark() : light();
  theme.palette = palette;
  set_people(theme);
  set_levels(theme);
  return theme;
}

Theme film_theme(const Theme& theme) {
  Theme film = make_theme(ThemeKind::Dark, theme.palette);
  film.surface = colour_from_hex(0x0C1016).with_alpha(0.80F);
  film.shadow = colour_from_hex(0x000000).with_alpha(0.20F);
  film.raised = colour_from_hex(0xFFFFFF).with_alpha(0.14F);
  film.hovered = colour_from_hex(0xFFFFFF).with_alpha(0.24F);
  film.pressed = colour_from_hex(0xFFFFFF).with_alpha(0.09F);
  film.line = colour_from_hex(0xFFFFFF).with_alpha(0.14F);
  film.quiet = colour_from_hex(0xC4CCD8);
  film.faint = colour_from_hex(0x9AA6B4);
  return film;
}

double contrast_ratio(const Colour& a, const Colour& b) {
  const double first = luminance(a), second = luminance(b);
  return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

double type_size(TextStyle style) {
  switch (style) {
    case TextStyle::Caption:
      return 12;
    case TextStyle::Body:
    case TextStyle::Strong:
      return 14;
    case TextStyle::Title:
      return 17;
    case TextStyle::Heading:
      return 24;
    case TextStyle::Display:
      return 44;
    case TextStyle::Giant:
      return 76;
  }
  return 14;
}

FontWeight type_weight(TextStyle style) {
  return style == TextStyle::Caption || style == TextStyle::Body ? FontWeight::Medium : FontWeight::Bold;
}

}  // namespace posecoach
