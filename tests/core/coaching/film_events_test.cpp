#include "core/coaching/film_events.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "core/coaching/way_fit.h"
#include "tests/core/coaching/strokes.h"

namespace posecoach {
namespace {

constexpr double kFrame_s = 1.0 / 30;
const Sight kFromFront{Vec3(0, 0, -1)}, kFromBehind{Vec3(1, 0, 0)};

struct Film {
  AuthoredMotion stroke;
  JointTrack track;
  SwingEvents found;
};

Film film_of(const GolfScript& script, double fps = 30) {
  AuthoredMotion stroke = make_stroke(script, {.frames_per_second = fps});
  JointTrack track = JointTrack::from_motion(stroke.motion).value();
  SwingEvents found = find_swing_events(track).value();
  return {std::move(stroke), std::move(track), std::move(found)};
}

GolfScript stretched(const char* from, const char* to, double factor) {
  GolfScript script = bundled_script("swing").value();
  script.stretch(from, to, factor);
  return script;
}

// As a pose model sees hands behind a head.
JointTrack with_trembling_hands(const Film& film, double from_s, double metres) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0, metres);
  const Skeleton& body = film.stroke.motion.skeleton();
  const int left = body.find(HumanoidJoint::LeftWrist), right = body.find(HumanoidJoint::RightWrist);
  return JointTrack::from_motion(with_positions(film.stroke.motion,
                                                [&](int frame, int joint, const Vec3& p) {
                                                  const bool is_hand = joint == left || joint == right;
                                                  return is_hand && film.track.time(frame) > from_s
                                                             ? p + Vec3(normal(random), normal(random),
                                                                        normal(random))
                                                             : p;
                                                }))
      .value();
}

TEST(FilmEvents, the_finish_does_not_move_with_hands_that_tremble_behind_the_head) {
  const Film film = film_of(bundled_script("swing").value());
  const JointTrack seen = with_trembling_hands(film, film.stroke.time_of("mid_follow_through"), 0.03);
  for (const auto& [view, sight] :
       {std::pair(Viewpoint::FaceOn, kFromFront), std::pair(Viewpoint::DownTheLine, kFromBehind)}) {
    const auto still = finish_in_film({film.found, film.track, sight, view});
    const auto trembles = finish_in_film({film.found, seen, sight, view});
    ASSERT_TRUE(still && trembles);
    EXPECT_NEAR(*trembles, *still, 0.01);
  }
}

TEST(FilmEvents, the_finish_comes_so_much_later_as_the_golfer_takes_longer_to_it) {
  for (const auto& [view, sight] :
       {std::pair(Viewpoint::FaceOn, kFromFront), std::pair(Viewpoint::DownTheLine, kFromBehind)}) {
    const auto takes_s = [&, &view = view, &sight = sight](double factor) {
      const Film film = film_of(stretched("mid_follow_through", "finish", factor));
      return finish_in_film({film.found, film.track, sight, view}).value() -
             film.stroke.time_of("mid_follow_through");
    };
    const double usual_s = takes_s(1);
    for (const double factor : {0.75, 1.4})
      EXPECT_NEAR(takes_s(factor), factor * usual_s, kFrame_s) << factor;
  }
}

TEST(FilmEvents, a_film_that_ends_in_the_follow_through_has_no_finish) {
  const Film film = film_of(bundled_script("swing").value());
  const JointTrack cut = film.track.resampled(30, 0, film.stroke.time_of("mid_follow_through") + 0.15);
  SwingEvents found = find_swing_events(cut).value();
  EXPECT_FALSE(found.is_end_seen);
  EXPECT_FALSE(finish_in_film({found, cut, kFromFront, Viewpoint::FaceOn}));
}

TEST(FilmEvents, the_toe_up_is_found_whatever_depth_the_arms_are_given) {
  for (const double lean : {-0.5, 0.0, 0.5}) {
    const Film film = film_of(bundled_script("swing").value());
    const Vec3& sight = *kFromBehind.direction;
    const JointTrack seen = film.track.mapped(
        [&](const Vec3& p) { return p + lean * p.y * sight - 0.3 * glm::dot(p, sight) * sight; });
    SwingEvents found = find_swing_events(seen, {{}, kFromBehind}).value();
    const auto toe_up = toe_up_down_the_line({found, seen, kFromBehind, Viewpoint::DownTheLine});
    ASSERT_TRUE(toe_up) << lean;
    EXPECT_NEAR(*toe_up, film.stroke.time_of("toe_up"), kFrame_s) << lean;
  }
}

TEST(FilmEvents, the_takeaway_is_found_of_golfers_who_start_slowly_and_quickly) {
  double earliest = 1, latest = -1;
  for (const double factor : {0.75, 1.0, 1.35}) {
    const Film film = film_of(stretched("takeaway", "toe_up", factor));
    const SeenStroke stroke{film.found, film.track, kFromBehind, Viewpoint::DownTheLine};
    const auto takeaway = takeaway_down_the_line(stroke, film.stroke.time_of("toe_up"));
    ASSERT_TRUE(takeaway);
    const double late_s = *takeaway - film.stroke.time_of("takeaway");
    earliest = std::min(earliest, late_s);
    latest = std::max(latest, late_s);
  }
  // A share of the backswing, of which all of them had the same seen, would be six frames apart.
  EXPECT_LT(latest - earliest, 2 * kFrame_s);
}

// What a pose model shows of a putt from behind: the hands stay where they are, the shoulder line turns
// across the picture, and sticks to where it rested when it comes near.
JointTrack putt_from_behind(const AuthoredMotion& putt, double sticks_within_m) {
  const JointTrack track = JointTrack::from_motion(putt.motion).value();
  const Skeleton& body = putt.motion.skeleton();
  const int left = body.find(HumanoidJoint::LeftShoulder), right = body.find(HumanoidJoint::RightShoulder);
  const auto line = [&](int frame) {
    return track.position(frame, HumanoidJoint::LeftShoulder).z -
           track.position(frame, HumanoidJoint::RightShoulder).z;
  };
  return JointTrack::from_motion(
             with_positions(putt.motion,
                            [&](int frame, int joint, const Vec3& p) {
                              if (joint != left && joint != right) return p;
                              const double turned = line(frame) - line(0);
                              const double shown =
                                  std::copysign(std::max(0.0, std::abs(turned) - sticks_within_m), turned);
                              const double moved = 0.5 * (shown - turned);
                              return p + Vec3(0, 0, joint == left ? moved : -moved);
                            }))
      .value();
}

TEST(FilmEvents,
     of_a_putt_from_behind_are_told_by_the_shoulders_however_long_it_takes_and_however_they_stick) {
  for (const double sticks_m : {0.0, 0.004}) {
    const auto late = [&](double factor) {
      GolfScript script = bundled_script("putt").value();
      script.stretch("top", "impact", factor);
      const AuthoredMotion putt = make_stroke(script, {.name = "putt", .frames_per_second = 30});
      const JointTrack seen = putt_from_behind(putt, sticks_m);
      const SwingEvents found = find_swing_events(JointTrack::from_motion(putt.motion).value()).value();
      const PuttDownTheLine told =
          putt_down_the_line({found, seen, kFromBehind, Viewpoint::DownTheLine}).value();
      EXPECT_NEAR(told.top_s, putt.time_of("top"), 2 * kFrame_s) << sticks_m;
      EXPECT_NEAR(told.takeaway_s, putt.time_of("takeaway"), 3 * kFrame_s) << sticks_m;
      return told.impact_s - putt.time_of("impact");
    };
    const double usual_s = late(1);
    EXPECT_LT(std::abs(usual_s), 0.1);
    for (const double factor : {0.8, 1.5}) EXPECT_NEAR(late(factor), usual_s, 1.2 * kFrame_s) << sticks_m;
  }
}

TEST(FilmEvents, are_as_late_in_slow_motion_as_it_is_slow) {
  const Film film = film_of(bundled_script("swing").value());
  const JointTrack slow = JointTrack::from_motion(slowed_by(film.stroke.motion, 3)).value();
  const SwingEvents found = find_swing_events(slow).value();
  const SeenStroke usual{film.found, film.track, kFromBehind, Viewpoint::DownTheLine};
  const SeenStroke slowly{found, slow, kFromBehind, Viewpoint::DownTheLine, 3};
  const double toe_up_s = film.stroke.time_of("toe_up");
  EXPECT_NEAR(takeaway_down_the_line(slowly, 3 * toe_up_s).value(),
              3 * takeaway_down_the_line(usual, toe_up_s).value(), 0.05);
  EXPECT_NEAR(toe_up_down_the_line(slowly).value(), 3 * toe_up_down_the_line(usual).value(), 0.05);
  EXPECT_NEAR(finish_in_film(slowly).value(), 3 * finish_in_film(usual).value(), 0.1);
}

std::vector<double> noisy_way(int begins, int ends, int count, bool is_to_turn, double noise) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0, noise);
  std::vector<double> values;
  for (int i = 0; i < count; ++i) {
    const double time = std::clamp(static_cast<double>(i - begins) / (ends - begins), 0.0, 1.0);
    values.push_back(3 + 2 * (is_to_turn ? to_turn(time) : to_rest(time)) + normal(random));
  }
  return values;
}

TEST(WayFit, finds_where_a_way_begins_and_ends_below_the_noise) {
  for (const double noise : {0.0, 0.02, 0.06}) {
    const int tolerance = noise == 0 ? 0 : noise < 0.05 ? 2 : 4;
    const auto before = fit_rest_before(noisy_way(60, 160, 161, true, noise), 20, 150, 160, 40);
    ASSERT_TRUE(before);
    EXPECT_NEAR(*before, 60, tolerance) << noise;
    const auto after = fit_rest_after(noisy_way(-100, 100, 180, false, noise), 0, 20, 160, 40);
    ASSERT_TRUE(after);
    EXPECT_NEAR(*after, 100, tolerance) << noise;
  }
}

TEST(WayFit, the_misfit_of_the_right_shape_is_none_whatever_its_size_and_place) {
  const std::vector<double> values = noisy_way(0, 50, 51, true, 0);
  EXPECT_NEAR(misfit(values, 0, 50, [](int i) { return -7 * to_turn(i / 50.0); }), 0, 1e-12);
  EXPECT_GT(misfit(values, 0, 50, [](int i) { return to_rest(i / 50.0); }), 1e-4);
}

TEST(WayFit, has_no_answer_where_there_is_no_room) {
  const std::vector<double> values(10, 0.0);
  EXPECT_FALSE(fit_rest_before(values, 8, 9, 9, 5));
  EXPECT_FALSE(fit_rest_after(values, 8, 0, 9, 5));
}

}  // namespace
}  // namespace posecoach
