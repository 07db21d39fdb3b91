#include <array>
#include <cmath>
#include <vector>

#include "ui/panels/live_panels.h"
#include "ui/widgets/controls.h"

namespace posecoach {
namespace {

enum class Shape { None, Ring, Disc, Triangle, Dots };

// Every state has its own colour, its own shape and its own word; none is told by one of them alone.
struct Look {
  Shape shape = Shape::None;
  Colour colour;
  std::array<std::string_view, 2> words;
  std::string_view hint;
};

Look look_of(LoopState state, const Theme& theme) {
  switch (state) {
    case LoopState::Armed:
      return {Shape::Ring, theme.warning, {"STAND", "STILL"}, "Take your address and hold it."};
    case LoopState::Ready:
      return {Shape::Disc, theme.good, {"SWING", ""}, "Whenever you like."};
    case LoopState::Swinging:
      return {Shape::Triangle, colour_from_hex(0xFFFFFF), {"GO ON", ""}, "I see your swing."};
    case LoopState::Analyzing:
      return {Shape::Dots, theme.accent, {"WAIT", ""}, "Your answer is coming."};
    case LoopState::Off:
    case LoopState::Replay:
      break;
  }
  return {};
}

void draw_shape(Ui& ui, Shape shape, const Vec2& at, double size, const Colour& colour) {
  switch (shape) {
    case Shape::None:
      return;
    case Shape::Ring:
      return ui.ring(at, 0.42 * size, colour, 0.13 * size);
    case Shape::Disc:
      return ui.disc(at, 0.48 * size, colour);
    case Shape::Triangle: {
      const std::array<Vec2, 3> points = {at + size * Vec2(-0.36, -0.44), at + size * Vec2(0.46, 0),
                                          at + size * Vec2(-0.36, 0.44)};
      return ui.polygon(points, colour);
    }
    case Shape::Dots:
      for (int i = 0; i < 3; ++i) {
        const double beat = 0.5 + 0.5 * std::sin(5 * ui.time_s() - 1.1 * i);
        ui.disc(at + size * Vec2(0.36 * (i - 1), 0), size * (0.09 + 0.05 * beat), colour);
      }
  }
}

}  // namespace

void draw_state_frame(const PanelContext& context, const Rect& area) {
  if (!context.model.snapshot) return;
  const LoopState state = context.model.snapshot->loop;
  const Look look = look_of(state, context.theme());
  if (look.shape == Shape::None) return;
  const double pulse =
      state == LoopState::Armed ? 0.55 + 0.45 * std::pow(std::cos(2.4 * context.ui.time_s()), 2) : 1;
  context.ui.outline(area, look.colour.with_alpha(static_cast<float>(pulse)), 0,
                     state == LoopState::Ready || state == LoopState::Swinging ? 14 : 9);
}

void draw_state_banner(const PanelContext& context, const Rect& area) {
  if (!context.model.snapshot) return;
  const Look look = look_of(context.model.snapshot->loop, context.theme());
  if (look.shape == Shape::None) return;
  Ui& ui = context.ui;
  const bool has_second = !look.words[1].empty();
  const double shape_size = 150, line = 74;
  const double height = 24 + shape_size + 16 + line * (has_second ? 2 : 1) + 52;
  const Rect card{area.x, area.y + std::max(0.0, 0.5 * (area.height - height)), area.width, height};
  ui.fill(card, colour_from_hex(0x0A0D12).with_alpha(0.86F), radius::kLarge);
  ui.outline(card, look.colour, radius::kLarge, 4);
  Rect inner = card.inset(14, 24);
  draw_shape(ui, look.shape, inner.take_top(shape_size, 16).centre(), shape_size, look.colour);
  for (const std::string_view word : look.words) {
    if (word.empty()) continue;
    const bool is_wide = ui.text_width(TextStyle::Giant, word) > inner.width;
    ui.text_in(is_wide ? TextStyle::Display : TextStyle::Giant, inner.take_top(line), word, look.colour,
               Align::Centre);
  }
  ui.text_in(TextStyle::Title, inner.take_bottom(30), look.hint, context.theme().text, Align::Centre);
}

}  // namespace posecoach
