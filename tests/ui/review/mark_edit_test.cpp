#include "ui/review/mark_edit.h"

#include <gtest/gtest.h>

namespace posecoach {
namespace {

TEST(MarkEdit, a_line_is_finished_by_its_second_point_and_an_angle_by_its_third) {
  for (const DrawingKind kind : {DrawingKind::Line, DrawingKind::Angle}) {
    DrawingTool tool{kind, {}, {}};
    std::optional<Drawing> drawing;
    for (std::size_t i = 0; i < point_count(kind); ++i) {
      EXPECT_FALSE(drawing.has_value());
      drawing = with_point(tool, {50.0 * static_cast<double>(i), 10}, 7);
    }
    ASSERT_TRUE(drawing.has_value());
    EXPECT_EQ(drawing->frame, 7);
    EXPECT_EQ(drawing->points_px.size(), point_count(kind));
    EXPECT_FALSE(tool.kind.has_value());  // the pointer moves the film again
  }
}

TEST(MarkEdit, two_presses_in_one_place_are_one_point) {
  DrawingTool tool{DrawingKind::Line, {}, {}};
  EXPECT_FALSE(with_point(tool, {10, 10}, 0));
  EXPECT_FALSE(with_point(tool, {10.3, 10}, 0));
  EXPECT_TRUE(with_point(tool, {40, 10}, 0));
}

TEST(MarkEdit, everything_can_be_taken_back_and_done_again) {
  MarkHistory history;
  std::vector<Marks> steps = {Marks()};
  steps.push_back(with_event(steps.back(), "top", 40));
  steps.push_back(with_key_picture_toggled(steps.back(), 12));
  steps.push_back(with_event(steps.back(), "top", 42));
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) remember(history, steps[i]);
  Marks now = steps.back();
  for (std::size_t i = steps.size() - 1; i-- > 0;) {
    now = undone(history, now).value();
    EXPECT_EQ(now, steps[i]);
  }
  EXPECT_FALSE(undone(history, now));
  for (std::size_t i = 1; i < steps.size(); ++i) {
    now = redone(history, now).value();
    EXPECT_EQ(now, steps[i]);
  }
  now = undone(history, now).value();
  remember(history, now);
  EXPECT_FALSE(redone(history, now));  // something new was done since
}

TEST(MarkEdit, an_event_is_moved_once_however_often) {
  const Marks marks = with_event(with_event({}, "top", 40), "top", 44);
  ASSERT_EQ(marks.events.size(), 1U);
  EXPECT_EQ(marks.events[0].frame, 44);
}

TEST(MarkEdit, key_pictures_come_and_go_in_order) {
  Marks marks;
  for (const int picture : {30, 5, 17, 5}) marks = with_key_picture_toggled(marks, picture);
  EXPECT_EQ(marks.key_pictures, (std::vector<int>{17, 30}));
}

TEST(MarkEdit, the_nearest_drawing_of_the_picture_is_found) {
  Marks marks;
  marks.drawings = {{DrawingKind::Line, 3, {{0, 0}, {100, 0}}},
                    {DrawingKind::Line, 3, {{0, 20}, {100, 20}}},
                    {DrawingKind::Line, 4, {{0, 6}, {100, 6}}}};
  EXPECT_EQ(drawing_at(marks, 3, {50, 6}, 10), 0U);
  EXPECT_EQ(drawing_at(marks, 3, {50, 14}, 10), 1U);
  EXPECT_FALSE(drawing_at(marks, 3, {150, 10}, 10));
  EXPECT_EQ(last_drawing(marks, 3), 1U);
  EXPECT_FALSE(last_drawing(marks, 9));
}

}  // namespace
}  // namespace posecoach
