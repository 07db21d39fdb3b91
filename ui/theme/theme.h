// How the window looks: colours by what they mean, sizes by what they are for. Plain values; sizes are
// points, which the window turns into pixels by its scale.
#pragma once

#include "ui/render/colour.h"
#include "ui/render/figure.h"

namespace posecoach {

enum class ThemeKind { Dark, Light };

struct Theme {
  ThemeKind kind = ThemeKind::Dark;
  Palette palette = Palette::RedGreen;

  Colour background;          // behind everything
  Colour surface;             // cards
  Colour raised;              // what lies on cards: fields, buttons
  Colour hovered, pressed;    // of what is raised
  Colour line;                // borders and rules
  Colour text, quiet, faint;  // first, second, third in importance
  Colour accent, on_accent;   // what to press first, what is chosen
  Colour good, warning, bad;  // always with a shape or a word beside them
  Colour scrim;               // over what a dialog hides
  Colour shadow;
  Colour student, coach;            // as their skeletons
  Colour student_text, coach_text;  // readable as text on a card
};

Theme make_theme(ThemeKind kind, Palette palette);

// For what lies over a film: the same meanings on dark glass, whatever the theme.
Theme film_theme(const Theme& theme);

// How clearly two opaque colours are told apart, 1 to 21 (WCAG 2 contrast ratio).
double contrast_ratio(const Colour& a, const Colour& b);

// Distances, in points.
namespace space {
inline constexpr double kTiny = 4, kSmall = 8, kMedium = 12, kLarge = 16, kHuge = 24, kGiant = 32;
}
namespace radius {
inline constexpr double kSmall = 6, kMedium = 10, kLarge = 14;
}

// Type sizes; the em in points is type_size().
enum class TextStyle { Caption, Body, Strong, Title, Heading, Display, Giant };
inline constexpr int kTextStyleCount = 7;
double type_size(TextStyle style);
FontWeight type_weight(TextStyle style);

}  // namespace posecoach
