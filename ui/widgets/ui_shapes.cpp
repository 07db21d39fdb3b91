#include "ui/widgets/imgui_values.h"
#include "ui/widgets/ui.h"

namespace posecoach {
namespace {

float f(double value) {
  return static_cast<float>(value);
}

}  // namespace

void Ui::fill(const Rect& rect, const Colour& colour, double corner_radius) {
  if (rect.is_empty() || colour.alpha <= 0) return;
  draw_list().AddRectFilled(top_left(rect), bottom_right(rect), im(colour), f(corner_radius));
}

void Ui::outline(const Rect& rect, const Colour& colour, double corner_radius, double width) {
  if (rect.is_empty() || colour.alpha <= 0) return;
  const Rect middle = rect.inset(0.5 * width);
  // AddRect moves its corners half a unit inwards by itself.
  const ImVec2 a = im(middle.corner() - Vec2(0.5)), b = im(Vec2(middle.right(), middle.bottom()) + Vec2(0.5));
  draw_list().AddRect(a, b, im(colour), f(std::max(0.0, corner_radius - 0.5 * width)), 0, f(width));
}

void Ui::gradient(const Rect& rect, const Colour& top, const Colour& bottom) {
  if (rect.is_empty()) return;
  draw_list().AddRectFilledMultiColor(top_left(rect), bottom_right(rect), im(top), im(top), im(bottom),
                                      im(bottom));
}

void Ui::shadow(const Rect& rect, double corner_radius, double spread) {
  constexpr int kLayers = 6;
  const Colour& colour = theme_->shadow;
  for (int i = 0; i < kLayers; ++i) {
    const double by = spread * (i + 1) / kLayers;
    const Rect larger{rect.x - by, rect.y - by + 0.35 * spread, rect.width + 2 * by, rect.height + 2 * by};
    fill(larger, colour.with_alpha(colour.alpha / (kLayers + 1)), corner_radius + by);
  }
}

void Ui::line(const Vec2& from, const Vec2& to, const Colour& colour, double width) {
  // AddLine moves both ends by half a unit.
  draw_list().AddLine(im(from - Vec2(0.5)), im(to - Vec2(0.5)), im(colour), f(width));
}

void Ui::polyline(std::span<const Vec2> points, const Colour& colour, double width) {
  ImDrawList& list = draw_list();
  for (const Vec2& point : points) list.PathLineTo(im(point));
  list.PathStroke(im(colour), 0, f(width));
}

void Ui::polygon(std::span<const Vec2> points, const Colour& colour) {
  ImDrawList& list = draw_list();
  for (const Vec2& point : points) list.PathLineTo(im(point));
  list.PathFillConvex(im(colour));
}

void Ui::disc(const Vec2& centre, double radius, const Colour& colour) {
  draw_list().AddCircleFilled(im(centre), f(radius), im(colour));
}

void Ui::ring(const Vec2& centre, double radius, const Colour& colour, double width) {
  draw_list().AddCircle(im(centre), f(radius), im(colour), 0, f(width));
}

void Ui::arc(const Vec2& centre, double radius, double from, double to, const Colour& colour, double width) {
  ImDrawList& list = draw_list();
  list.PathArcTo(im(centre), f(radius), f(from - kPi / 2), f(to - kPi / 2));
  list.PathStroke(im(colour), 0, f(width));
}

void Ui::texture(TextureName name, const Rect& rect, double corner_radius, bool mirrored) {
  if (name == 0 || rect.is_empty()) return;
  // Dear ImGui names textures by pointers.
  void* const id = reinterpret_cast<void*>(name);
  const ImVec2 from(mirrored ? 1.0F : 0.0F, 0), to(mirrored ? 0.0F : 1.0F, 1);
  draw_list().AddImageRounded(id, top_left(rect), bottom_right(rect), from, to, IM_COL32_WHITE,
                              f(corner_radius));
}

}  // namespace posecoach
