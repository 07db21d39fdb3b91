// One frame of the window for those who draw it: shapes, text, places to press, keys. Everything is in
// points; what is drawn later lies over what was drawn before. Lives from Interface::begin to Interface::end.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/theme/theme.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/rect.h"
#include "ui/widgets/scene_views.h"

struct ImDrawList;

namespace posecoach {

struct InterfaceState;

struct FrameInput {
  Vec2 size{1280, 720};  // of the window, points
  double scale = 1;      // pixels a point
  double time_s = 0;     // of a clock that never goes back
  double elapsed_s = 1.0 / 60;
  std::vector<KeyPress> keys;           // pressed since the last frame
  std::vector<KeyPress> repeated_keys;  // that stayed down
  std::vector<std::string> dropped_files;
};

// What the user does with a place on the screen.
struct Interaction {
  bool hovered = false;
  bool held = false;                       // the button is down since it was pressed here
  bool pressed = false, released = false;  // the button, in this frame
  bool clicked = false;                    // or Enter while focused
  bool double_clicked = false;
  bool focused = false;  // by the keyboard
  Vec2 mouse;            // where it is, points
  Vec2 drag;             // how far since the last frame, while held
  double wheel = 0;      // while hovered
};

enum class Focus { ByKeyboard, Never };

// Whether a key that stays down counts again and again.
enum class Repeats { Ignored, Count };

class Ui {
 public:
  Ui(InterfaceState& state, const Theme& theme, SceneViews& views, FrameInput input);
  Ui(const Ui&) = delete;
  Ui& operator=(const Ui&) = delete;

  const Theme& theme() const { return *theme_; }
  SceneViews& views() { return views_; }
  double time_s() const { return input_.time_s; }
  Vec2 mouse() const;        // points
  Vec2 mouse_moved() const;  // since the last frame
  double elapsed_s() const { return input_.elapsed_s; }
  double scale() const { return input_.scale; }
  Rect whole() const { return {0, 0, input_.size.x, input_.size.y}; }
  const std::vector<std::string>& dropped_files() const { return input_.dropped_files; }

  // Shapes.
  void fill(const Rect& rect, const Colour& colour, double corner_radius = 0);
  void outline(const Rect& rect, const Colour& colour, double corner_radius, double width = 1);
  void gradient(const Rect& rect, const Colour& top, const Colour& bottom);
  void shadow(const Rect& rect, double corner_radius, double spread);
  void line(const Vec2& from, const Vec2& to, const Colour& colour, double width = 1);
  void polyline(std::span<const Vec2> points, const Colour& colour, double width);
  void polygon(std::span<const Vec2> points, const Colour& colour);  // convex
  void disc(const Vec2& centre, double radius, const Colour& colour);
  void ring(const Vec2& centre, double radius, const Colour& colour, double width);
  // Angles in radians, 0 at twelve o'clock, clockwise.
  void arc(const Vec2& centre, double radius, double from, double to, const Colour& colour, double width);
  // Nothing for texture 0. `mirrored` exchanges left and right.
  void texture(TextureName name, const Rect& rect, double corner_radius = 0, bool mirrored = false);

  // Text. `at` is the left end, middle or right end of the base line, by `align`.
  void text(TextStyle style, const Vec2& at, std::string_view words, const Colour& colour,
            Align align = Align::Left);
  // In one line, capitals in the middle of the rectangle's height, cut with an ellipsis where it is too wide.
  void text_in(TextStyle style, const Rect& rect, std::string_view words, const Colour& colour,
               Align align = Align::Left);
  // Broken into lines from the rectangle's top, at most `most_lines`; returns the height that they take.
  double paragraph(TextStyle style, const Rect& rect, std::string_view words, const Colour& colour,
                   int most_lines = 100, Align align = Align::Left);
  double text_width(TextStyle style, std::string_view words) const;
  double paragraph_height(TextStyle style, double width, std::string_view words, int most_lines = 100) const;
  double line_height(TextStyle style) const;
  double cap_height(TextStyle style) const;

  // Places to press. The id is unique within its scope.
  Interaction region(std::string_view id, const Rect& rect, Focus focus = Focus::ByKeyboard);
  // A line of text to write in; true in the frame in which it was changed. `lines` > 1: several lines.
  bool text_field(std::string_view id, const Rect& rect, std::string& words, std::string_view hint,
                  int lines = 1);
  void write_in(std::string_view field);  // gives it the keyboard
  // Whether Enter ended the writing in this line, in this frame.
  bool was_entered(std::string_view field);
  bool is_writing() const;  // a text field has the keyboard
  void tooltip(const Rect& of, const Interaction& on, std::string_view words);
  void focus_ring(const Rect& rect, double corner_radius, const Interaction& on);
  // Draws attention to what the pointer would press.
  void use_hand_pointer();

  // Keys that nobody took yet; none while a text field has the keyboard, and none for what lies below an open
  // layer. Enter alone belongs to the place that the keyboard has ringed, where there is one.
  bool take_key(const KeyPress& press, Repeats repeats = Repeats::Ignored);
  // The next one, whatever it is.
  std::optional<KeyPress> take_any_key();
  void take_all_keys();
  bool has_ring() const;  // whether the keyboard has ringed a place
  // Rings the place of this id as soon as it is drawn.
  void focus_on(std::string_view id);
  // Arrow keys that nobody took walk to the next place in their direction; once, at the end of a frame.
  void walk_by_arrows();

  // Nesting; use the guards below.
  void push_id(std::string_view id);
  void pop_id();
  void push_clip(const Rect& rect);
  void pop_clip();
  // A list that scrolls within `area`; returns where its content begins, moved by the scrolling.
  Rect begin_scroll(std::string_view id, const Rect& area, double content_height);
  void end_scroll();
  // Over everything so far, without taking the keyboard.
  void begin_overlay(std::string_view id, const Rect& area);
  void end_overlay();
  // Over everything so far, with the keyboard for itself. What lies below gets no mouse within `area`.
  void begin_layer(std::string_view id, const Rect& area);
  void end_layer();
  bool is_open(std::string_view popup) const;  // popups are opened by name, one at a time
  void open(std::string_view popup);
  void close_popup();

  // Another theme for what follows; returns the one before.
  const Theme* exchange_theme(const Theme* theme);

 private:
  struct Line {
    std::string_view words;
    double width = 0;
  };
  bool take(const KeyPress& press, Repeats repeats);
  std::vector<Line> broken(TextStyle style, double width, std::string_view words, int most_lines) const;

  InterfaceState& state_;
  const Theme* theme_;
  SceneViews& views_;
  FrameInput input_;
};

class IdScope {
 public:
  IdScope(Ui& ui, std::string_view id) : ui_(ui) { ui_.push_id(id); }
  IdScope(const IdScope&) = delete;
  IdScope& operator=(const IdScope&) = delete;
  ~IdScope() { ui_.pop_id(); }

 private:
  Ui& ui_;
};

class ClipScope {
 public:
  ClipScope(Ui& ui, const Rect& rect) : ui_(ui) { ui_.push_clip(rect); }
  ClipScope(const ClipScope&) = delete;
  ClipScope& operator=(const ClipScope&) = delete;
  ~ClipScope() { ui_.pop_clip(); }

 private:
  Ui& ui_;
};

class ThemeScope {
 public:
  ThemeScope(Ui& ui, const Theme& theme) : ui_(ui), before_(ui.exchange_theme(&theme)) {}
  ThemeScope(const ThemeScope&) = delete;
  ThemeScope& operator=(const ThemeScope&) = delete;
  ~ThemeScope() { ui_.exchange_theme(before_); }

 private:
  Ui& ui_;
  const Theme* before_;
};

}  // namespace posecoach
