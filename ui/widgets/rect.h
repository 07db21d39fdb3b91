// Rectangles in points, origin top left, +Y down, and how to cut them up: layout is arithmetic on these.
#pragma once

#include <algorithm>

#include "core/base/math.h"

namespace posecoach {

struct Rect {
  double x = 0, y = 0, width = 0, height = 0;

  constexpr double right() const { return x + width; }
  constexpr double bottom() const { return y + height; }
  Vec2 corner() const { return {x, y}; }
  Vec2 size() const { return {width, height}; }
  Vec2 centre() const { return {x + 0.5 * width, y + 0.5 * height}; }
  constexpr bool contains(const Vec2& p) const {
    return p.x >= x && p.x < right() && p.y >= y && p.y < bottom();
  }
  constexpr bool is_empty() const { return width <= 0 || height <= 0; }

  constexpr Rect inset(double by) const { return inset(by, by); }
  constexpr Rect inset(double across, double down) const {
    return {x + across, y + down, std::max(0.0, width - 2 * across), std::max(0.0, height - 2 * down)};
  }
  constexpr Rect moved(double by_x, double by_y) const { return {x + by_x, y + by_y, width, height}; }

  // Cuts a strip off this rectangle, and `gap` behind it; returns the strip.
  constexpr Rect take_top(double amount, double gap = 0) {
    amount = std::min(amount, height);
    const Rect strip{x, y, width, amount};
    const double used = std::min(height, amount + gap);
    y += used;
    height -= used;
    return strip;
  }
  constexpr Rect take_bottom(double amount, double gap = 0) {
    amount = std::min(amount, height);
    const Rect strip{x, bottom() - amount, width, amount};
    height = std::max(0.0, height - amount - gap);
    return strip;
  }
  constexpr Rect take_left(double amount, double gap = 0) {
    amount = std::min(amount, width);
    const Rect strip{x, y, amount, height};
    const double used = std::min(width, amount + gap);
    x += used;
    width -= used;
    return strip;
  }
  constexpr Rect take_right(double amount, double gap = 0) {
    amount = std::min(amount, width);
    const Rect strip{right() - amount, y, amount, height};
    width = std::max(0.0, width - amount - gap);
    return strip;
  }
  // Column `index` of `count` equal ones.
  constexpr Rect column(int index, int count, double gap) const {
    const double each = (width - gap * (count - 1)) / count;
    return {x + index * (each + gap), y, each, height};
  }
};

// The largest rectangle of this shape inside `area`, in its middle.
constexpr Rect fitted(double width, double height, const Rect& area) {
  if (width <= 0 || height <= 0) return area;
  const double factor = std::min(area.width / width, area.height / height);
  return {area.x + 0.5 * (area.width - factor * width), area.y + 0.5 * (area.height - factor * height),
          factor * width, factor * height};
}

}  // namespace posecoach
