#include "ui/render/scene.h"

#include <glm/geometric.hpp>

namespace posecoach {

Box make_box(Vec2 top_left, Vec2 size, double corner_radius, Colour fill) {
  Box box;
  box.centre = top_left + 0.5 * size;
  box.half_size = 0.5 * size;
  box.corner_radius = corner_radius;
  box.fill = fill;
  return box;
}

Box make_line(Vec2 from, Vec2 to, double width, Colour colour) {
  const double length = glm::length(to - from);
  Box box;
  box.centre = 0.5 * (from + to);
  box.half_size = {0.5 * (length + width), 0.5 * width};
  box.corner_radius = 0.5 * width;
  if (length > 0) box.direction = (to - from) / length;
  box.fill = colour;
  return box;
}

Box make_disc(Vec2 centre, double radius, Colour fill) {
  return make_box(centre - Vec2(radius), Vec2(2 * radius), radius, fill);
}

}  // namespace posecoach
