// What lies on the live picture. Each panel is drawn into the area it is given.
#pragma once

#include "ui/panels/panel.h"

namespace posecoach {

void draw_live_picture(const PanelContext& context, const Rect& area);
// The hands-free loop's state, to be read from three metres: colour, shape and word.
void draw_state_banner(const PanelContext& context, const Rect& area);
// The frame around the picture in the state's colour.
void draw_state_frame(const PanelContext& context, const Rect& area);
void draw_set_up_checks(const PanelContext& context, const Rect& area);
void draw_address_advice(const PanelContext& context, const Rect& area);
void draw_measuring(const PanelContext& context, const Rect& area);
void draw_status_line(const PanelContext& context, const Rect& area);
void draw_live_controls(const PanelContext& context, const Rect& area);
// Opening, stalled, lost, ended: what is wrong and what to do.
void draw_source_message(const PanelContext& context, const Rect& area);
void draw_replay(const PanelContext& context, const Rect& area);

// For who has not kept a swing yet; gone once there is one.
bool shows_first_steps(const WindowModel& model, const WindowState& state);
void draw_first_steps(const PanelContext& context, const Rect& area);
double first_steps_height(const PanelContext& context, double width);

// How high the lists want to be in this width.
double set_up_checks_height(const PanelContext& context, double width);
double address_advice_height(const PanelContext& context, double width);

}  // namespace posecoach
