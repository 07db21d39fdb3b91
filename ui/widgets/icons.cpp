#include "ui/widgets/icons.h"

#include <array>
#include <cmath>
#include <vector>

namespace posecoach {
namespace {

// A drawing board of 24 by 24, its middle at (12, 12), as icons are usually designed.
class Board {
 public:
  Board(Ui& ui, const Vec2& centre, double size, const Colour& colour)
      : ui_(ui), origin_(centre - 0.5 * Vec2(size)), unit_(size / 24), colour_(colour) {
    stroke_ = std::max(1.25, 1.9 * unit_);
  }

  void lines(std::initializer_list<Vec2> points) {
    std::vector<Vec2> placed;
    for (const Vec2& point : points) placed.push_back(at(point));
    ui_.polyline(placed, colour_, stroke_);
    // Round ends.
    ui_.disc(placed.front(), 0.5 * stroke_, colour_);
    ui_.disc(placed.back(), 0.5 * stroke_, colour_);
  }
  void closed(std::initializer_list<Vec2> points) {
    std::vector<Vec2> placed;
    for (const Vec2& point : points) placed.push_back(at(point));
    placed.push_back(placed.front());
    placed.push_back(placed[1]);
    ui_.polyline(placed, colour_, stroke_);
  }
  void solid(std::initializer_list<Vec2> points) {
    std::vector<Vec2> placed;
    for (const Vec2& point : points) placed.push_back(at(point));
    ui_.polygon(placed, colour_);
  }
  void box(double x, double y, double width, double height, double corner = 2) {
    ui_.outline(place(x, y, width, height), colour_, corner * unit_, stroke_);
  }
  void solid_box(double x, double y, double width, double height, double corner = 1) {
    ui_.fill(place(x, y, width, height), colour_, corner * unit_);
  }
  void ring(Vec2 centre, double radius) { ui_.ring(at(centre), radius * unit_, colour_, stroke_); }
  void disc(Vec2 centre, double radius) { ui_.disc(at(centre), radius * unit_, colour_); }
  void arc(Vec2 centre, double radius, double from_degrees, double to_degrees) {
    ui_.arc(at(centre), radius * unit_, radians_from_degrees(from_degrees), radians_from_degrees(to_degrees),
            colour_, stroke_);
  }
  void star(bool is_filled) {
    std::array<Vec2, 12> points;
    for (std::size_t i = 0; i < 12; ++i) {
      const double angle = kPi * static_cast<double>(i) / 5, radius = i % 2 == 0 ? 9.5 : 4.2;
      points[i] = at(Vec2(12, 12.6) + radius * Vec2(std::sin(angle), -std::cos(angle)));
    }
    if (is_filled)
      for (std::size_t i = 0; i < 10; i += 2) {
        const std::array<Vec2, 4> arm = {at({12, 12.6}), points[(i + 9) % 10], points[i], points[i + 1]};
        ui_.polygon(arm, colour_);
      }
    ui_.polyline(points, colour_, stroke_);
  }

 private:
  Vec2 at(const Vec2& p) const { return origin_ + unit_ * p; }
  Rect place(double x, double y, double width, double height) const {
    return {origin_.x + unit_ * x, origin_.y + unit_ * y, unit_ * width, unit_ * height};
  }

  Ui& ui_;
  Vec2 origin_;
  double unit_;
  Colour colour_;
  double stroke_;
};

void draw_player(Board& b, Icon icon) {
  switch (icon) {
    case Icon::Play:
      return b.solid({{7, 4.5}, {19.5, 12}, {7, 19.5}});
    case Icon::Pause:
      b.solid_box(6, 5, 4.2, 14);
      return b.solid_box(13.8, 5, 4.2, 14);
    case Icon::StepBack:
      b.solid({{17, 5.5}, {17, 18.5}, {8.5, 12}});
      return b.solid_box(5, 5.5, 2.4, 13);
    case Icon::StepForward:
      b.solid({{7, 5.5}, {15.5, 12}, {7, 18.5}});
      return b.solid_box(16.6, 5.5, 2.4, 13);
    case Icon::ToStart:
      b.lines({{11, 6}, {5, 12}, {11, 18}});
      return b.lines({{19, 6}, {13, 12}, {19, 18}});
    case Icon::ToEnd:
      b.lines({{5, 6}, {11, 12}, {5, 18}});
      return b.lines({{13, 6}, {19, 12}, {13, 18}});
    case Icon::Loop:
      b.arc({12, 12}, 7.5, -60, 120);
      b.arc({12, 12}, 7.5, 120, 250);
      return b.solid({{2.2, 9.5}, {8.6, 9.5}, {5.4, 4.2}});
    default:
      return;
  }
}

void draw_place(Board& b, Icon icon) {
  switch (icon) {
    case Icon::Live:
      b.disc({12, 12}, 3.2);
      b.arc({12, 12}, 8.2, 45, 135);
      return b.arc({12, 12}, 8.2, 225, 315);
    case Icon::Review:
      b.box(3, 5, 18, 14, 3);
      return b.solid({{10, 8.8}, {15.5, 12}, {10, 15.2}});
    case Icon::Library:
      b.box(3.5, 3.5, 7, 7, 1.5);
      b.box(13.5, 3.5, 7, 7, 1.5);
      b.box(3.5, 13.5, 7, 7, 1.5);
      return b.box(13.5, 13.5, 7, 7, 1.5);
    case Icon::SetUp:
      b.lines({{4, 7}, {20, 7}});
      b.lines({{4, 17}, {20, 17}});
      b.disc({9, 7}, 3);
      return b.disc({15, 17}, 3);
    case Icon::Person:
      b.ring({12, 8}, 4);
      return b.arc({12, 21}, 7.5, -75, 75);
    case Icon::Coach:
      b.ring({12, 7}, 3.2);
      b.lines({{12, 10.5}, {12, 16}});
      b.lines({{6, 13}, {12, 12}, {18, 13}});
      return b.lines({{8, 21}, {12, 16}, {16, 21}});
    case Icon::Camera:
      b.box(3, 6.5, 13, 11, 2.5);
      return b.closed({{16.5, 11}, {21, 8}, {21, 16}, {16.5, 13}});
    case Icon::Body:
      b.ring({12, 5}, 2.6);
      b.lines({{4, 10}, {20, 10}});
      b.lines({{12, 8}, {12, 15}});
      return b.lines({{8.5, 21}, {12, 15}, {15.5, 21}});
    default:
      return;
  }
}

void draw_deed(Board& b, Icon icon) {
  switch (icon) {
    case Icon::Star:
      return b.star(false);
    case Icon::StarFilled:
      return b.star(true);
    case Icon::Trash:
      b.lines({{4.5, 7}, {19.5, 7}});
      b.lines({{9, 7}, {9.5, 4}, {14.5, 4}, {15, 7}});
      b.lines({{6.5, 7}, {7.5, 20}, {16.5, 20}, {17.5, 7}});
      b.lines({{10.5, 11}, {10.5, 16}});
      return b.lines({{13.5, 11}, {13.5, 16}});
    case Icon::Restore:
      b.arc({13, 13}, 6.5, -80, 170);
      b.lines({{13, 6.5}, {6, 6.5}});
      return b.lines({{9, 3}, {5.5, 6.5}, {9, 10}});
    case Icon::Search:
      b.ring({10.5, 10.5}, 6);
      return b.lines({{15.2, 15.2}, {20, 20}});
    case Icon::Export:
      b.lines({{12, 15}, {12, 4}});
      b.lines({{7.5, 8}, {12, 3.5}, {16.5, 8}});
      return b.lines({{4.5, 14}, {4.5, 20}, {19.5, 20}, {19.5, 14}});
    case Icon::Import:
      b.lines({{12, 4}, {12, 15}});
      b.lines({{7.5, 10.8}, {12, 15.3}, {16.5, 10.8}});
      return b.lines({{4.5, 14}, {4.5, 20}, {19.5, 20}, {19.5, 14}});
    case Icon::Plus:
      b.lines({{12, 5}, {12, 19}});
      return b.lines({{5, 12}, {19, 12}});
    case Icon::Check:
      return b.lines({{5, 12.5}, {10, 17.5}, {19.5, 6.5}});
    case Icon::Cross:
      b.lines({{6, 6}, {18, 18}});
      return b.lines({{18, 6}, {6, 18}});
    case Icon::Record:
      b.ring({12, 12}, 8.5);
      return b.disc({12, 12}, 4.6);
    case Icon::Measure:
      b.box(2.5, 8, 19, 8, 1.5);
      for (const double x : {6.5, 10.0, 14.0, 17.5}) b.lines({{x, 8.5}, {x, 12}});
      return;
    case Icon::Retry:
      b.arc({12, 12}, 7.5, 60, 330);
      return b.solid({{5.5, 2.8}, {11.5, 5.4}, {6.6, 9.6}});
    case Icon::Note:
      b.box(5, 3.5, 14, 17, 2);
      b.lines({{8.5, 9}, {15.5, 9}});
      return b.lines({{8.5, 13}, {13.5, 13}});
    default:
      return;
  }
}

void draw_tool(Board& b, Icon icon) {
  switch (icon) {
    case Icon::Line:
      b.lines({{6, 18}, {18, 6}});
      b.disc({5.5, 18.5}, 2.4);
      return b.disc({18.5, 5.5}, 2.4);
    case Icon::Angle:
      b.lines({{19, 19}, {5, 19}, {15, 5}});
      return b.arc({5, 19}, 8, 35, 90);
    case Icon::Bookmark:
      return b.closed({{7, 4}, {17, 4}, {17, 20}, {12, 15.5}, {7, 20}});
    case Icon::Undo:
      b.lines({{5, 9}, {14, 9}});
      b.arc({14, 14}, 5, 0, 180);
      b.lines({{14, 19}, {9, 19}});
      return b.lines({{9, 5}, {5, 9}, {9, 13}});
    case Icon::Folder:
      return b.closed({{3.5, 6}, {9.5, 6}, {11.5, 8.5}, {20.5, 8.5}, {20.5, 18.5}, {3.5, 18.5}});
    default:
      return;
  }
}

void draw_sign(Board& b, Icon icon) {
  switch (icon) {
    case Icon::Warning:
      b.closed({{12, 4}, {21, 20}, {3, 20}});
      b.lines({{12, 10}, {12, 14}});
      return b.disc({12, 17.2}, 1.2);
    case Icon::Information:
      b.ring({12, 12}, 8.5);
      b.lines({{12, 11.5}, {12, 16.5}});
      return b.disc({12, 8}, 1.2);
    case Icon::Keyboard:
      b.box(2.5, 6, 19, 12, 2);
      for (const double x : {7.0, 12.0, 17.0}) b.disc({x, 10}, 1.1);
      return b.lines({{8, 14.5}, {16, 14.5}});
    case Icon::SideBySide:
      b.box(3, 5, 8, 14, 1.5);
      return b.box(13, 5, 8, 14, 1.5);
    case Icon::Superpose:
      b.box(3, 3.5, 12, 12, 2);
      return b.box(9, 8.5, 12, 12, 2);
    case Icon::Sound:
      b.arc({12, 12}, 4.8, 40, 140);
      b.arc({13, 12}, 8, 45, 135);
      return b.solid({{4, 9.5}, {8, 9.5}, {12.5, 5.5}, {12.5, 18.5}, {8, 14.5}, {4, 14.5}});
    case Icon::SoundOff:
      b.lines({{16, 9.5}, {21, 14.5}});
      b.lines({{21, 9.5}, {16, 14.5}});
      return b.solid({{4, 9.5}, {8, 9.5}, {12.5, 5.5}, {12.5, 18.5}, {8, 14.5}, {4, 14.5}});
    case Icon::Mirror:
      b.lines({{12, 3}, {12, 21}});
      b.closed({{9, 7}, {9, 17}, {3, 17}});
      return b.solid({{15, 7}, {21, 17}, {15, 17}});
    case Icon::ArrowDown:
      return b.lines({{6, 9}, {12, 15}, {18, 9}});
    case Icon::ArrowRight:
      return b.lines({{9, 6}, {15, 12}, {9, 18}});
    case Icon::Clock:
      b.ring({12, 12}, 8.5);
      return b.lines({{12, 7}, {12, 12.4}, {15.5, 14.5}});
    case Icon::FullScreen:
      b.lines({{4, 9}, {4, 4}, {9, 4}});
      b.lines({{15, 4}, {20, 4}, {20, 9}});
      b.lines({{20, 15}, {20, 20}, {15, 20}});
      return b.lines({{9, 20}, {4, 20}, {4, 15}});
    default:
      return;
  }
}

}  // namespace

void draw_icon(Ui& ui, Icon icon, const Vec2& centre, double size, const Colour& colour) {
  Board board(ui, centre, size, colour);
  // Each draws the icons of its own table.
  draw_player(board, icon);
  draw_place(board, icon);
  draw_deed(board, icon);
  draw_tool(board, icon);
  draw_sign(board, icon);
}

}  // namespace posecoach
