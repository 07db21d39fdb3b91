// The kept swings: search, cards, and what can be done with the chosen one.
#pragma once

#include "ui/panels/panel.h"

namespace posecoach {

void draw_library_bar(const PanelContext& context, const Rect& area);
void draw_swing_cards(const PanelContext& context, const Rect& area);
void draw_swing_details(const PanelContext& context, const Rect& area);

// What search and filter let through, in the model's order.
std::vector<const SwingCard*> shown_swings(const WindowModel& model, const WindowState& state);
// Null when nothing is chosen.
const SwingCard* chosen_swing(const WindowModel& model, const WindowState& state);

}  // namespace posecoach
