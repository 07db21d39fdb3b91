#include "core/coaching/swing_finder.h"

#include <gtest/gtest.h>

#include "core/motion/bundled_motion.h"
#include "core/motion/pose_file.h"
#include "core/pipeline/ghost_driver.h"
#include "core/pipeline/live_lift.h"
#include "tests/support/filmed_golfer.h"

namespace posecoach {
namespace {

using enum GolferPart::Kind;

Sight sight_of(const PinholeCamera& camera) {
  return {glm::normalize(Vec3(0, 0, 1) * camera.rotation_camera_from_world)};
}

struct Found {
  std::vector<FoundSwing> swings;
  std::vector<double> seen_at_s;  // when each was told
  double swinging_s = 0;          // how long it looked like a swing
};

// As live: what the pose stage sees, lifted frame by frame, every `step`-th frame.
Found find_swings(const GolferFilm& film, std::size_t step = 1) {
  Found found;
  LiveLift lift;
  SwingFinder finder;
  for (std::size_t i = 0; i < film.count(); i += step) {
    const auto student =
        lift.step(film.times[i], film.people[i], film.camera.width_px, film.camera.height_px);
    if (!student) continue;
    if (const auto swing = finder.step(film.times[i], joint_moment(student->positions, student->confidence),
                                       sight_of(student->camera))) {
      found.swings.push_back(*swing);
      found.seen_at_s.push_back(to_seconds(film.times[i]));
    }
    if (finder.phase() == SwingFinder::Phase::Swinging) found.swinging_s += static_cast<double>(step) / 30;
  }
  return found;
}

struct Scene {
  std::string stroke;
  bool is_left_handed = false;
  bool is_face_on = true;
};

PinholeCamera camera_of(const Scene& scene) {
  return scene.is_face_on ? face_on_camera() : down_the_line_camera(scene.is_left_handed);
}

class SwingFinderScenes : public testing::TestWithParam<Scene> {};

TEST_P(SwingFinderScenes, every_stroke_is_found_once_with_its_begin_and_end) {
  const Scene& scene = GetParam();
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U, 10U, 11U, 12U}) {
    const GolferFilm film = film_golfer({.stroke = scene.stroke,
                                         .is_left_handed = scene.is_left_handed,
                                         .parts = {{Walk, 3},
                                                   {Stand, 2},
                                                   {Stroke},
                                                   {Walk, 4},
                                                   {Stand, 1.5},
                                                   {Waggle, 2.5},
                                                   {Stand, 1},
                                                   {Stroke},
                                                   {Stand, 3},
                                                   {Stroke},
                                                   {Walk, 3}}},
                                        camera_of(scene), kWebcamNoise, seed);
    const Found found = find_swings(film);
    ASSERT_EQ(found.swings.size(), 3U) << "seed " << seed;
    for (std::size_t k = 0; k < 3; ++k) {
      // The bundled strokes start with a rest of some tenths of a second.
      EXPECT_GT(to_seconds(found.swings[k].begin), film.stroke_begin_s[k]);
      EXPECT_LT(to_seconds(found.swings[k].begin), film.stroke_begin_s[k] + 1.3);
      EXPECT_LT(found.seen_at_s[k], film.stroke_end_s[k] + 0.6) << "told in time";
      EXPECT_EQ(found.swings[k].kind, scene.stroke == "putt" ? StrokeKind::Putt : StrokeKind::FullSwing);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, SwingFinderScenes,
                         testing::Values(Scene{"swing"}, Scene{"swing", true}, Scene{"swing", false, false},
                                         Scene{"swing", true, false}, Scene{"putt"}, Scene{"putt", true}),
                         [](const auto& scene) {
                           return scene.param.stroke + (scene.param.is_left_handed ? "_left" : "_right") +
                                  (scene.param.is_face_on ? "_face_on" : "_down_the_line");
                         });

TEST(SwingFinder, small_and_large_bodies_are_served_alike) {
  for (const double size : {0.8, 1.15})
    for (const bool is_left_handed : {false, true})
      for (const bool is_face_on : {true, false}) {
        const GolferFilm film =
            film_golfer({.stroke = "swing",
                         .is_left_handed = is_left_handed,
                         .parts = {{Stand, 2}, {Stroke}, {Stand, 2}, {Stroke}, {Walk, 2}},
                         .size = size},
                        is_face_on ? face_on_camera() : down_the_line_camera(is_left_handed), kWebcamNoise);
        EXPECT_EQ(find_swings(film).swings.size(), 2U) << size << is_left_handed << is_face_on;
      }
}

TEST(SwingFinder, a_swing_in_slow_motion_is_found_whole) {
  const AuthoredMotion swing = bundled_authored_motion("swing").value();
  for (const double slower : {2.0, 3.0})
    for (const bool is_face_on : {true, false})
      for (const unsigned seed : {1U, 2U, 3U}) {
        const GolferFilm film =
            film_golfer({.parts = {{Stand, 2}, {Stroke}, {Stand, 2}}, .slower = slower},
                        is_face_on ? face_on_camera() : down_the_line_camera(false), kWebcamNoise, seed);
        const Found found = find_swings(film);
        ASSERT_EQ(found.swings.size(), 1U) << slower << is_face_on;
        EXPECT_GT(to_seconds(found.swings[0].end),
                  film.stroke_begin_s[0] + slower * (swing.time_of("finish") - 0.4))
            << slower << is_face_on;
      }
}

TEST(SwingFinder, short_putts_are_found) {
  for (const double length : {0.5, 0.7})
    for (const bool is_left_handed : {false, true})
      for (const unsigned seed : {1U, 2U, 3U}) {
        const GolferFilm film = film_golfer(
            {.stroke = "putt",
             .is_left_handed = is_left_handed,
             .parts =
                 {{Walk, 2}, {Stand, 2}, {Stroke}, {Stand, 3}, {Stroke}, {Stand, 2}, {Waggle, 2}, {Walk, 2}},
             .length = length},
            face_on_camera(), kFilteredNoise, seed);
        const Found found = find_swings(film);
        EXPECT_EQ(found.swings.size(), 2U) << length << is_left_handed;
        for (const FoundSwing& swing : found.swings) EXPECT_EQ(swing.kind, StrokeKind::Putt);
      }
}

// Down the line the hands go along the line of sight: the shoulders alone tell the stroke.
TEST(SwingFinder, putts_down_the_line_are_found) {
  for (const double length : {0.5, 1.0, 1.5})
    for (const double fps : {30.0, 60.0})
      for (const bool is_left_handed : {false, true})
        for (const unsigned seed : {1U, 2U, 3U}) {
          const GolferFilm film = film_golfer({.stroke = "putt",
                                               .is_left_handed = is_left_handed,
                                               .fps = fps,
                                               .parts = {{Walk, 2},
                                                         {Stand, 2},
                                                         {Stroke},
                                                         {Stand, 3},
                                                         {Waggle, 2},
                                                         {Stand, 1},
                                                         {Stroke},
                                                         {Stand, 2},
                                                         {Walk, 2}},
                                               .length = length},
                                              down_the_line_camera(is_left_handed), kFilteredNoise, seed);
          const Found found = find_swings(film);
          EXPECT_EQ(found.swings.size(), 2U) << length << " " << fps << is_left_handed;
          for (std::size_t k = 0; k < std::min<std::size_t>(found.swings.size(), 2); ++k) {
            EXPECT_EQ(found.swings[k].kind, StrokeKind::Putt);
            EXPECT_GT(to_seconds(found.swings[k].begin), film.stroke_begin_s[k]);
            EXPECT_LT(found.seen_at_s[k], film.stroke_end_s[k] + 0.6) << "told in time";
          }
        }
}

TEST(SwingFinder, waggles_and_walking_about_are_not_swings) {
  for (const PoseNoise& noise : {kWebcamNoise, kFilteredNoise})
    for (const bool is_face_on : {true, false}) {
      const GolferFilm film = film_golfer(
          {.parts = {{Walk, 6}, {Stand, 2}, {Waggle, 8}, {Stand, 1}, {TPose, 3}, {Stand, 2}, {Walk, 6}}},
          is_face_on ? face_on_camera() : down_the_line_camera(false), noise);
      EXPECT_TRUE(find_swings(film).swings.empty()) << is_face_on << noise.image_px;
    }
}

TEST(SwingFinder, half_a_swing_back_and_to_the_ball_again_is_no_swing) {
  for (const double turn_s : {1.1, 1.25, 1.4})
    for (const bool is_face_on : {true, false})
      for (const unsigned seed : {1U, 2U}) {
        const GolferFilm film =
            film_golfer({.parts = {{Stand, 2},
                                   {Rehearse, turn_s},
                                   {Stand, 0.5},
                                   {Rehearse, turn_s},
                                   {Stand, 0.5},
                                   {Rehearse, turn_s},
                                   {Stand, 3},
                                   {Stroke},
                                   {Stand, 1}}},
                        is_face_on ? face_on_camera() : down_the_line_camera(false), kFilteredNoise, seed);
        const Found found = find_swings(film);
        ASSERT_EQ(found.swings.size(), 1U) << turn_s << is_face_on;
        EXPECT_GT(to_seconds(found.swings[0].begin), film.stroke_begin_s[0]) << turn_s << is_face_on;
      }
}

TEST(SwingFinder, a_waggle_right_before_the_stroke_does_not_hide_it) {
  for (const double waggle_s : {0.9, 1.3, 1.7, 2.1}) {
    const GolferFilm film = film_golfer({.parts = {{Stand, 2}, {Waggle, waggle_s}, {Stroke}, {Stand, 1}}},
                                        face_on_camera(), kWebcamNoise);
    EXPECT_EQ(find_swings(film).swings.size(), 1U) << waggle_s;
  }
}

TEST(SwingFinder, a_pose_stage_of_ten_frames_a_second_is_enough) {
  for (const bool is_face_on : {true, false}) {
    const GolferFilm film =
        film_golfer({.parts = {{Stand, 2}, {Stroke}, {Stand, 2}, {Stroke}, {Stand, 1}}},
                    is_face_on ? face_on_camera() : down_the_line_camera(false), kWebcamNoise);
    EXPECT_EQ(find_swings(film, 3).swings.size(), 2U) << is_face_on;
  }
}

TEST(SwingFinder, a_person_who_stands_still_is_at_address_and_one_who_left_is_not) {
  const GolferFilm film = film_golfer({.parts = {{Stand, 2}, {Walk, 2}}}, face_on_camera(), kWebcamNoise);
  LiveLift lift;
  SwingFinder finder;
  for (std::size_t i = 0; i < film.count(); ++i) {
    const auto student = lift.step(film.times[i], film.people[i], 1280, 720);
    finder.step(film.times[i], joint_moment(student->positions, student->confidence),
                sight_of(student->camera));
    if (i == 55) {
      EXPECT_EQ(finder.phase(), SwingFinder::Phase::AtAddress);
    }
  }
  EXPECT_EQ(finder.phase(), SwingFinder::Phase::Searching);
}

}  // namespace
}  // namespace posecoach
