#include "core/coaching/film_habits.h"

#include <gtest/gtest.h>

#include <array>

#include "core/coaching/compare.h"
#include "tests/core/coaching/strokes.h"

namespace posecoach {
namespace {

constexpr std::array kSwingEvents = {"address",       "toe_up", "mid_backswing",      "top",
                                     "mid_downswing", "impact", "mid_follow_through", "finish"};

int offered(Viewpoint view, StrokeKind kind) {
  int count = 0;
  for (const char* event : kSwingEvents)
    for (std::size_t k = 0; k < kFeatureCount; ++k)
      count += feature_habit(view, kind, event, static_cast<Feature>(k)).has_value() ? 1 : 0;
  return count;
}

TEST(FilmHabits, offer_no_measure_along_the_line_of_sight) {
  for (const char* event : kSwingEvents) {
    for (const Feature feature :
         {Feature::HipsToBall, Feature::ChestToBall, Feature::HeadToBall, Feature::HandsToBall})
      EXPECT_FALSE(feature_habit(Viewpoint::FaceOn, StrokeKind::FullSwing, event, feature)) << event;
    for (const Feature feature : {Feature::HipsToTarget, Feature::ChestToTarget, Feature::HeadToTarget})
      EXPECT_FALSE(feature_habit(Viewpoint::DownTheLine, StrokeKind::FullSwing, event, feature)) << event;
  }
}

TEST(FilmHabits, from_an_angle_offer_only_what_both_sides_do) {
  EXPECT_GT(offered(Viewpoint::FaceOn, StrokeKind::FullSwing), 5);
  EXPECT_GT(offered(Viewpoint::DownTheLine, StrokeKind::FullSwing), 5);
  const int both = offered(Viewpoint::Between, StrokeKind::FullSwing);
  EXPECT_GT(both, 0);
  EXPECT_LT(both, offered(Viewpoint::FaceOn, StrokeKind::FullSwing));
  EXPECT_EQ(offered(Viewpoint::DownTheLine, StrokeKind::Putt), 0);
}

TEST(FilmHabits, are_taken_off_what_is_seen) {
  const FeatureHabit habit{0.02, 0.5, 0.05};
  EXPECT_NEAR(habit.truth_from(0.02), 0, 1e-12);
  EXPECT_NEAR(habit.truth_from(0.07), 0.1, 1e-12);
}

struct Film {
  JointTrack student, coach;
  SwingEvents student_events, coach_events;
  Alignment alignment;
};

Film film_of(double hold_top_s) {
  const JointTrack coach = JointTrack::from_motion(make_stroke().motion).value();
  GolfScript script = bundled_script("swing").value();
  script.stretch("transition", "top", 1 + hold_top_s / 0.055);
  const JointTrack student =
      JointTrack::from_motion(make_stroke(script, {.frames_per_second = 60}).motion).value();
  const SwingEvents se = find_swing_events(student).value(), ce = find_swing_events(coach).value();
  const auto window = [](const SwingEvents& e) {
    return TimeWindow{e.events.front().time_s, e.events.back().time_s};
  };
  return {student, coach, se, ce, align(student, coach, window(se), window(ce))};
}

TEST(FilmHabits, leave_events_alone_that_were_seen_from_all_sides) {
  const Film film = film_of(0);
  const SwingEvents right = events_put_right(film.student_events, film.coach_events, film.alignment,
                                             film.student, Viewpoint::AllSides);
  for (std::size_t k = 0; k < right.events.size(); ++k)
    EXPECT_EQ(right.events[k].time_s, film.student_events.events[k].time_s);
}

TEST(FilmHabits, move_events_by_little_and_keep_them_in_order) {
  const Film film = film_of(0);
  for (const Viewpoint view : {Viewpoint::FaceOn, Viewpoint::DownTheLine, Viewpoint::Between}) {
    const SwingEvents right =
        events_put_right(film.student_events, film.coach_events, film.alignment, film.student, view);
    EXPECT_GE(right.takeaway_s, 0);
    for (std::size_t k = 0; k < right.events.size(); ++k) {
      EXPECT_NEAR(right.events[k].time_s, film.student_events.events[k].time_s, 0.1) << right.events[k].name;
      EXPECT_EQ(right.events[k].frame, film.student.nearest_frame(right.events[k].time_s));
      if (k > 0) {
        EXPECT_LT(right.events[k - 1].time_s, right.events[k].time_s) << right.events[k].name;
      }
    }
  }
}

TEST(FilmHabits, do_not_move_the_top_of_a_film_down_the_line_to_where_the_coachs_would_be) {
  const Film film = film_of(1.5);
  const SwingEvents right = events_put_right(film.student_events, film.coach_events, film.alignment,
                                             film.student, Viewpoint::DownTheLine);
  EXPECT_NEAR(right.time_of("top"), film.student_events.time_of("top"), 0.05);
}

TEST(FilmHabits, the_same_swing_seen_from_twenty_degrees_off_scores_within_three_points) {
  const Motion coach = make_stroke().motion;
  const Motion student = make_stroke({.frames_per_second = 30, .body = {.height_m = 1.80}}).motion;
  CompareOptions options;
  options.view = Viewpoint::FaceOn;
  const auto score_from = [&](double degrees) {
    const double angle = radians_from_degrees(degrees);
    options.sight.direction = Vec3(std::sin(angle), 0, std::cos(angle));
    return compare(trembling(student, 0.02), coach, options).value().score.percent;
  };
  const double straight = score_from(0);
  for (const double degrees : {-20.0, -10.0, 10.0, 20.0})
    EXPECT_NEAR(score_from(degrees), straight, 3) << degrees;
}

}  // namespace
}  // namespace posecoach
