// Between our values and Dear ImGui's. Included by the .cpp files of ui/widgets only.
#pragma once

#include <imgui.h>

#include "ui/render/colour.h"
#include "ui/widgets/rect.h"

namespace posecoach {

inline ImVec2 im(const Vec2& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y)};
}
inline ImU32 im(const Colour& c) {
  return ImGui::ColorConvertFloat4ToU32({c.red, c.green, c.blue, c.alpha});
}
inline ImVec2 top_left(const Rect& r) {
  return im(r.corner());
}
inline ImVec2 bottom_right(const Rect& r) {
  return im(Vec2(r.right(), r.bottom()));
}

// The list of the window that is being drawn, with edges as fine as the screen's pixels.
inline ImDrawList& draw_list() {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list._FringeScale = 1 / ImGui::GetIO().DisplayFramebufferScale.x;
  return list;
}

}  // namespace posecoach
