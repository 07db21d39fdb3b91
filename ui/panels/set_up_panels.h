// The choices that stay: camera, person, coach, looks.
#pragma once

#include "ui/panels/panel.h"

namespace posecoach {

void draw_camera_choice(const PanelContext& context, const Rect& area);
void draw_person(const PanelContext& context, const Rect& area);
void draw_coach_list(const PanelContext& context, const Rect& area);
void draw_looks(const PanelContext& context, const Rect& area);

}  // namespace posecoach
