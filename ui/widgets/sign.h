// The program's sign: a golfer in the student's green, the coach's backswing behind him in red. The same
// lines as the icon on the desktop (assets/desktop/virtual-pose-coach.svg), in the colours of the palette.
#pragma once

#include <vector>

#include "ui/widgets/ui.h"

namespace posecoach {

// On a board of 128 by 128, in the order in which they are drawn.
struct SignLine {
  enum class Ink { Coach, Student, Room };
  Ink ink = Ink::Student;
  double width = 1;
  std::vector<Vec2> points;
};
const std::vector<SignLine>& sign_lines();

// Within a square of this side around the centre.
void draw_sign(Ui& ui, const Vec2& centre, double size);

}  // namespace posecoach
