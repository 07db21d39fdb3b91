// What the user presses: buttons, switches, choices. Each is drawn where it is told, and says what happened.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "ui/widgets/icons.h"
#include "ui/widgets/ui.h"

namespace posecoach {

enum class ButtonLook {
  Primary,  // the one thing to do next
  Plain,
  Quiet  // no box until the pointer is over it
};

struct Button {
  std::string_view id;
  std::string_view words = {};  // may be empty where there is an icon
  Icon icon = Icon::None;
  ButtonLook look = ButtonLook::Plain;
  std::string_view hint = {};  // tooltip, with its key
  bool is_on = false;          // chosen, running
  bool is_enabled = true;
};

// As wide as its contents want.
double button_width(const Ui& ui, const Button& button);
bool draw_button(Ui& ui, const Rect& rect, const Button& button);

// One of several, side by side. Returns the chosen one.
int draw_segments(Ui& ui, std::string_view id, const Rect& rect, std::span<const std::string_view> words,
                  int chosen);

// On or off, with its words at the left.
bool draw_switch(Ui& ui, std::string_view id, const Rect& rect, std::string_view words, bool is_on);

// A word or two in a rounded box.
struct Pill {
  std::string_view words;
  Colour ink, paper;
  Icon icon = Icon::None;
};
double pill_width(const Ui& ui, const Pill& pill);
void draw_pill(Ui& ui, const Rect& rect, const Pill& pill);

// A list that drops down. Returns the index that was chosen in this frame, or -1.
struct Choice {
  std::string title, detail;
};
int draw_dropdown(Ui& ui, std::string_view id, const Rect& rect, std::string_view shown,
                  std::span<const Choice> choices, int chosen, Icon icon = Icon::None);

// A surface with a border; returns what is inside its padding.
Rect draw_card(Ui& ui, const Rect& rect, double padding = 16);
// The same with a heading; returns what is below it.
Rect draw_titled_card(Ui& ui, const Rect& rect, std::string_view title, Icon icon = Icon::None);

// `fraction` below 0: busy, end unknown.
void draw_progress(Ui& ui, const Rect& rect, double fraction);

// Part of a circle for 0 to 100 with the number in it.
void draw_score_ring(Ui& ui, const Vec2& centre, double radius, double percent, TextStyle style);
// Behind what is chosen.
Colour chosen_paper(const Theme& theme);
Colour score_colour(const Theme& theme, double percent);

// Words in the middle of a place where there is nothing yet.
void draw_empty(Ui& ui, const Rect& rect, Icon icon, std::string_view title, std::string_view words);

}  // namespace posecoach
