#include "ui/widgets/sign.h"

#include <array>
#include <cmath>

namespace posecoach {
namespace {

constexpr double kBoard = 128;

// The way of the club's head, a part of a circle between two of the board's points.
std::vector<Vec2> swing_arc() {
  const Vec2 from(25, 34), to(99, 106);
  constexpr double kRadius = 62;
  const Vec2 middle = 0.5 * (from + to), half = 0.5 * (to - from);
  const double length = std::hypot(half.x, half.y);
  const Vec2 centre =
      middle + std::sqrt(kRadius * kRadius - length * length) / length * Vec2(half.y, -half.x);
  const double begin = std::atan2(from.y - centre.y, from.x - centre.x) + 2 * kPi,
               end = std::atan2(to.y - centre.y, to.x - centre.x);
  std::vector<Vec2> arc;
  constexpr int kSteps = 24;
  for (int i = 0; i <= kSteps; ++i) {
    const double angle = begin + (end - begin) * i / kSteps;
    arc.push_back(centre + kRadius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return arc;
}

}  // namespace

const std::vector<SignLine>& sign_lines() {
  using Ink = SignLine::Ink;
  static const std::vector<SignLine> lines = {
      {Ink::Coach, 8.5, {{60, 48}, {37, 55}}},
      {Ink::Coach, 4.5, {{37, 55}, {25, 34}}},
      {Ink::Student, 9.5, {{63, 79}, {53, 94}, {48, 111}}},
      {Ink::Student, 9.5, {{63, 79}, {75, 93}, {79, 111}}},
      {Ink::Student, 12.5, {{61, 47}, {63, 78}}},
      {Ink::Room, 13.5, {{63, 48}, {80, 72}}},  // the arm stands off from the body
      {Ink::Student, 8.5, {{63, 48}, {80, 72}}},
      {Ink::Student, 4.5, {{80, 72}, {98, 105}}}};
  return lines;
}

void draw_sign(Ui& ui, const Vec2& centre, double size) {
  const Theme film = film_theme(ui.theme());
  const double unit = size / kBoard;
  const Vec2 origin = centre - 0.5 * Vec2(size);
  const Colour room = colour_from_hex(0x1A2129);
  ui.fill({origin.x + 4 * unit, origin.y + 4 * unit, 120 * unit, 120 * unit}, room, 27 * unit);
  const auto at = [&](const Vec2& point) { return origin + unit * point; };
  std::vector<Vec2> placed;
  static const std::vector<Vec2> arc = swing_arc();
  for (const Vec2& point : arc) placed.push_back(at(point));
  ui.polyline(placed, film.coach.with_alpha(0.35F), 5 * unit);
  for (const SignLine& line : sign_lines()) {
    const Colour colour = line.ink == SignLine::Ink::Coach     ? film.coach
                          : line.ink == SignLine::Ink::Student ? film.student
                                                               : room;
    placed.clear();
    for (const Vec2& point : line.points) placed.push_back(at(point));
    ui.polyline(placed, colour, line.width * unit);
    for (const Vec2& point : placed) ui.disc(point, 0.5 * line.width * unit, colour);
  }
  ui.disc(at({61, 27}), 10.5 * unit, film.student);
  ui.disc(at({107, 108}), 4.5 * unit, colour_from_hex(0xFFFFFF));
}

}  // namespace posecoach
