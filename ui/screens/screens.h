// The window's screens, each a whole of panels, and the window around them. Pure functions of model and
// state; what the user wants done comes back as intents.
#pragma once

#include "ui/panels/panel.h"

namespace posecoach {

void draw_live_screen(const PanelContext& context, const Rect& area);
// Where messages lie on it: above the bar, beside the answer to a swing.
Rect live_messages_area(const WindowModel& model, const Rect& area);
void draw_review_screen(const PanelContext& context, const Rect& area);
void draw_library_screen(const PanelContext& context, const Rect& area);
void draw_set_up_screen(const PanelContext& context, const Rect& area);

// Before there is anything to show.
void draw_starting(Ui& ui, const Rect& area);

// Rail, screen, messages, dialogs, keys.
void draw_window(const PanelContext& context, const Rect& area);

}  // namespace posecoach
