#include "core/coaching/film_habits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/coaching/alignment.h"
#include "core/coaching/compare.h"
#include "core/coaching/film_events.h"
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

TEST(FilmHabits, cancel_between_two_films_from_one_side_and_tell_nothing_between_two_sides) {
  const auto habit = [](Viewpoint student, Viewpoint coach) {
    return feature_habit(Viewpoints{student, coach}, StrokeKind::FullSwing, "top", Feature::ShoulderTilt);
  };
  const auto exact = habit(Viewpoint::FaceOn, Viewpoint::AllSides);
  const auto alike = habit(Viewpoint::DownTheLine, Viewpoint::DownTheLine);
  const auto of_line = habit(Viewpoint::DownTheLine, Viewpoint::AllSides);
  EXPECT_FALSE(exact);
  ASSERT_TRUE(alike && of_line);
  EXPECT_NE(of_line->usual_error, 0);
  EXPECT_EQ(alike->usual_error, 0);
  EXPECT_GT(alike->clear, of_line->clear);
  EXPECT_FALSE(habit(Viewpoint::FaceOn, Viewpoint::DownTheLine));
  EXPECT_FALSE(habit(Viewpoint::DownTheLine, Viewpoint::FaceOn));
  const auto other_way = habit(Viewpoint::AllSides, Viewpoint::DownTheLine);
  ASSERT_TRUE(other_way);
  EXPECT_EQ(other_way->usual_error, -of_line->usual_error);
}

TEST(FilmHabits, of_time_cancel_between_two_films_from_one_side) {
  const auto habit = [](Viewpoint student, Viewpoint coach) {
    return phase_habit({student, coach}, StrokeKind::FullSwing, "top", "impact");
  };
  const double of_film = habit(Viewpoint::FaceOn, Viewpoint::AllSides)->usual_error;
  EXPECT_NE(of_film, 0);
  EXPECT_NEAR(habit(Viewpoint::FaceOn, Viewpoint::FaceOn)->usual_error, 0, 1e-12);
  EXPECT_NEAR((1 + habit(Viewpoint::AllSides, Viewpoint::FaceOn)->usual_error) * (1 + of_film), 1, 1e-12);
  EXPECT_FALSE(habit(Viewpoint::AllSides, Viewpoint::AllSides));
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

  double answered_top_s() const { return alignment.student_time(coach_events.time_of("top")); }
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
  const SwingEvents right = events_put_right(film.student_events, film.student, Viewpoint::AllSides, {}, 1);
  for (std::size_t k = 0; k < right.events.size(); ++k)
    EXPECT_EQ(right.events[k].time_s, film.student_events.events[k].time_s);
}

TEST(FilmHabits, move_events_by_little_and_keep_them_in_order) {
  const Film film = film_of(0);
  for (const Viewpoint view : {Viewpoint::FaceOn, Viewpoint::DownTheLine, Viewpoint::Between}) {
    const Sight sight{view == Viewpoint::DownTheLine ? Vec3(1, 0, 0) : Vec3(0, 0, -1)};
    const SwingEvents right =
        events_put_right(film.student_events, film.student, view, sight, 1, film.answered_top_s());
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

TEST(FilmHabits, from_an_angle_tell_events_as_the_nearer_side_does) {
  const Film film = film_of(0);
  const auto toe_up_from = [&](double degrees) {
    const double angle = radians_from_degrees(degrees);
    const Sight sight{Vec3(std::sin(angle), 0, -std::cos(angle))};
    const SwingEvents right = events_put_right(film.student_events, film.student, Viewpoint::Between, sight,
                                               1, film.answered_top_s());
    const double of_line =
        toe_up_down_the_line({film.student_events, film.student, sight, Viewpoint::DownTheLine}).value();
    return std::pair(right.time_of("toe_up"), of_line);
  };
  for (const double degrees : {70.0, 110.0}) {
    const auto [told, of_line] = toe_up_from(degrees);
    EXPECT_EQ(told, of_line) << degrees;
  }
  for (const double degrees : {-20.0, 20.0}) {
    const auto [told, of_line] = toe_up_from(degrees);
    EXPECT_EQ(told, film.student_events.time_of("toe_up")) << degrees;
    EXPECT_NE(told, of_line) << degrees;
  }
}

TEST(FilmHabits, do_not_move_the_top_of_a_film_down_the_line_to_where_the_coachs_would_be) {
  const Film film = film_of(1.5);
  const SwingEvents right = events_put_right(film.student_events, film.student, Viewpoint::DownTheLine, {}, 1,
                                             film.answered_top_s());
  EXPECT_NEAR(right.time_of("top"), film.student_events.time_of("top"), 0.05);
}

TEST(FilmHabits, the_same_swing_seen_from_twenty_degrees_off_scores_within_three_points) {
  const Motion coach = make_stroke().motion;
  const Motion student = make_stroke({.frames_per_second = 30, .body = {.height_m = 1.80}}).motion;
  CompareOptions options;
  options.views.student = Viewpoint::FaceOn;
  const auto score_from = [&](double degrees) {
    const double angle = radians_from_degrees(degrees);
    options.sight.direction = Vec3(std::sin(angle), 0, std::cos(angle));
    return compare(trembling(student, 0.02), coach, options).value().score.percent;
  };
  const double straight = score_from(0);
  for (const double degrees : {-20.0, -10.0, 10.0, 20.0})
    EXPECT_NEAR(score_from(degrees), straight, 3) << degrees;
}

// What a pose model does: sideways and up as it is, but the depth leans with the place.
Motion with_guessed_depths(const Motion& motion, const Vec3& sight, const Vec3& lean) {
  return with_positions(motion, [&](int, int, const Vec3& p) {
    return p + sight * glm::dot(lean, p - glm::dot(p, sight) * sight);
  });
}

TEST(FilmHabits, guessed_depths_do_not_turn_the_coach) {
  const JointTrack coach = JointTrack::from_motion(make_stroke().motion).value();
  const Motion student = make_stroke({.frames_per_second = 30}).motion;
  const auto window = [](const JointTrack& track) {
    const SwingEvents found = find_swing_events(track).value();
    return TimeWindow{found.events.front().time_s, found.events.back().time_s};
  };
  for (const Vec3& sight : {Vec3(0, 0, -1), Vec3(-1, 0, 0)})
    for (const double lean : {-0.3, 0.3}) {
      const JointTrack seen =
          JointTrack::from_motion(with_guessed_depths(student, sight, lean * Vec3(1, 0, 1))).value();
      const Alignment alignment = align(seen, coach, window(JointTrack::from_motion(student).value()),
                                        window(coach), {.direction = sight});
      EXPECT_NEAR(degrees_from_radians(alignment.coach_yaw), 0, 4) << sight.x << " " << lean;
    }
}

}  // namespace
}  // namespace posecoach
