#include "ui/panels/library_panels.h"
#include "ui/screens/key_map.h"
#include "ui/screens/screens.h"
#include "ui/widgets/controls.h"

namespace posecoach {
namespace {

void move_choice(const PanelContext& context, int by) {
  const auto shown = shown_swings(context.model, context.state);
  if (shown.empty()) return;
  int at = by > 0 ? -1 : static_cast<int>(shown.size());
  for (std::size_t i = 0; i < shown.size(); ++i)
    if (shown[i]->id == context.state.selected) at = static_cast<int>(i);
  at = std::clamp(at + by, 0, static_cast<int>(shown.size()) - 1);
  context.state.selected = shown[static_cast<std::size_t>(at)]->id;
}

void use_keys(const PanelContext& context) {
  Ui& ui = context.ui;
  WindowState& state = context.state;
  // While Tab has ringed a place, the arrows walk from there.
  if (!ui.has_ring()) {
    for (const Key key : {Key::Right, Key::Down})
      while (ui.take_key({key}, Repeats::Count)) move_choice(context, 1);
    for (const Key key : {Key::Left, Key::Up})
      while (ui.take_key({key}, Repeats::Count)) move_choice(context, -1);
  }
  if (context.pressed(Command::Back)) {
    if (state.is_picking_second) state.screen = ScreenName::Review;
    state.is_picking_second = false;
    state.search.clear();
  }
  if (context.pressed(Command::Search)) ui.write_in("search");
  const SwingCard* const card = chosen_swing(context.model, state);
  if (card == nullptr) return;
  if (context.pressed(Command::ToggleStar)) context.want(intent::SetStar{card->id, !card->is_starred});
  if (context.pressed(Command::MoveToTrash)) {
    if (card->is_trashed)
      context.want(intent::RestoreSwing{card->id});
    else
      context.want(intent::TrashSwing{card->id});
  }
}

}  // namespace

void draw_library_screen(const PanelContext& context, const Rect& area) {
  Ui& ui = context.ui;
  ui.fill(area, context.theme().background);
  Rect rest = area.inset(18, 14);
  draw_library_bar(context, rest.take_top(38, 14));
  if (context.state.is_picking_second) {
    Rect note = rest.take_top(40, 12);
    ui.fill(note, mix(context.theme().raised, context.theme().accent, 0.22F), radius::kMedium);
    Rect inner = note.inset(14, 4);
    if (draw_button(ui, inner.take_right(84), {.id = "no second", .words = "Cancel"})) {
      context.state.is_picking_second = false;
      context.state.screen = ScreenName::Review;
    }
    ui.text_in(TextStyle::Strong, inner, "Choose the swing to compare with", context.theme().text);
  }
  if (!context.model.swings.empty())
    draw_swing_details(context, rest.take_right(std::clamp(0.26 * rest.width, 270.0, 400.0), 14));
  draw_swing_cards(context, rest);
  use_keys(context);
  // Enter opens what the arrows chose, unless a button has the keyboard.
  const SwingCard* const card = chosen_swing(context.model, context.state);
  if (card != nullptr && card->unreadable.empty() && !card->is_trashed && ui.take_key({Key::Enter})) {
    if (context.state.is_picking_second)
      context.want(intent::CompareWith{card->id});
    else
      context.want(intent::OpenSwing{card->id});
  }
}

}  // namespace posecoach
