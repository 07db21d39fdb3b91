// What the films and bodies of the review share.
#pragma once

#include <cstdint>
#include <initializer_list>

#include "ui/panels/panel.h"

namespace posecoach {

// Changes whenever the scene that these make does.
std::uint64_t scene_version(std::initializer_list<double> values, const void* what);
// Between the ankles.
Vec3 feet_of(const PosedBody& body);

// The pointer on the film, and what was and is being drawn there: lines, angles, larger and smaller.
void draw_marking(const PanelContext& context, const FilmPlace& place, int picture);
// What the keys of drawing and zooming do.
void use_marking_keys(const PanelContext& context);
// Changes what is marked, so that it can be taken back.
void set_marks(const PanelContext& context, Marks marks);

}  // namespace posecoach
