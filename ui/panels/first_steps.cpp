// What somebody who has not kept a swing yet does first, and what of it is done.
#include <array>

#include "ui/panels/live_panels.h"
#include "ui/widgets/controls.h"

namespace posecoach {
namespace {

constexpr double kPad = 16, kSign = 26, kGap = 10, kButton = 36;

struct Step {
  std::string_view title;
  std::string words;
  bool is_done = false;
};

// The first of its keys.
std::string key_of(const KeyMap& keys, Command command) {
  const std::string words = key_words(keys, command);
  return words.substr(0, words.find("  or"));
}

std::array<Step, 3> steps_of(const WindowModel& model, const KeyMap& keys) {
  bool is_seen = false, is_measured = false;
  if (model.snapshot && !model.snapshot->checks.empty())
    is_seen = std::all_of(model.snapshot->checks.begin(), model.snapshot->checks.end(),
                          [](const SetUpCheck& check) { return check.level == SetUpLevel::Good; });
  for (const PersonChoice& person : model.people)
    is_measured = is_measured || (person.id == model.person && person.is_measured);
  return {
      {{"Stand where all of you is seen", "The list at the right says how.", is_seen},
       {"Measure your body",
        "Press " + key_of(keys, Command::Measure) + " and stand still: the coach gets your arms and legs.",
        is_measured},
       {"Start hands-free and swing",
        "Press " + key_of(keys, Command::HandsFree) +
            ", step back, take your address. Each swing is found, replayed and kept.",
        false}}};
}

double step_height(const Ui& ui, const Step& step, double width) {
  return 22 + (step.is_done ? 0 : ui.paragraph_height(TextStyle::Body, width - kSign - kGap, step.words, 3)) +
         kGap;
}

}  // namespace

bool shows_first_steps(const WindowModel& model, const WindowState& state) {
  return !state.hides_first_steps && model.swings.empty() && model.library_message.empty() &&
         model.snapshot && model.snapshot->source_state == SourceState::Live &&
         model.snapshot->loop == LoopState::Off && !model.snapshot->measuring;
}

double first_steps_height(const PanelContext& context, double width) {
  double height = 2 * kPad + 30;
  for (const Step& step : steps_of(context.model, context.model.keys))
    height += step_height(context.ui, step, width - 2 * kPad);
  return height + kButton + 4;
}

void draw_first_steps(const PanelContext& context, const Rect& area) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  ui.shadow(area, radius::kLarge, 14);
  Rect inner = draw_card(ui, area, kPad);
  ui.text_in(TextStyle::Title, inner.take_top(22, 8), "Your first swing", theme.text);
  Rect button = inner.take_bottom(kButton, 4);
  const ClipScope clip(ui, area);
  int number = 0;
  for (const Step& step : steps_of(context.model, context.model.keys)) {
    ++number;
    const double height = step_height(ui, step, inner.width);
    if (inner.height < height) break;
    Rect row = inner.take_top(height);
    const Rect sign = row.take_left(kSign, kGap);
    const Vec2 at(sign.x + 12, sign.y + 11);
    if (step.is_done) {
      ui.disc(at, 11, theme.good);
      draw_icon(ui, Icon::Check, at, 14, colour_from_hex(0x0B0F14));
    } else {
      ui.ring(at, 11, theme.quiet, 1.6);
      ui.text(TextStyle::Strong, {at.x, at.y + 0.5 * ui.cap_height(TextStyle::Strong)},
              std::to_string(number), theme.text, Align::Centre);
    }
    ui.text_in(TextStyle::Strong, row.take_top(22), step.title, step.is_done ? theme.quiet : theme.text);
    if (!step.is_done) ui.paragraph(TextStyle::Body, row, step.words, theme.quiet, 3);
  }
  const Button close{.id = "hide first steps", .words = "Got it", .look = ButtonLook::Quiet};
  if (draw_button(ui, button.take_right(button_width(ui, close)), close))
    context.state.hides_first_steps = true;
}

}  // namespace posecoach
