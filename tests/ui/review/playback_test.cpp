#include "ui/review/playback.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace posecoach {
namespace {

// A film of uneven rate, as phones make them.
const std::vector<double> kTimes = {0, 0.04, 0.08, 0.12, 0.24, 0.28, 0.32, 0.36, 0.40, 0.44};
const std::vector<int> kEvents = {2, 5, 8};
const FilmMarks kFilm{kTimes, kEvents};

Playback playing(int frame = 0) {
  Playback playback;
  playback.frame = frame;
  playback.is_playing = true;
  return playback;
}

TEST(Playback, a_step_is_exactly_one_picture_and_stops_the_film) {
  Playback at = playing(3);
  at.into_frame_s = 0.1;
  at = applied(at, PlaybackCommand::StepForward, kFilm);
  EXPECT_EQ(at.frame, 4);
  EXPECT_FALSE(at.is_playing);
  for (int i = 0; i < 3; ++i) at = applied(at, PlaybackCommand::StepBack, kFilm);
  EXPECT_EQ(at.frame, 1);
}

TEST(Playback, steps_stay_within_the_film) {
  EXPECT_EQ(applied({}, PlaybackCommand::StepBack, kFilm).frame, 0);
  EXPECT_EQ(applied(moved_to({}, 9, kFilm), PlaybackCommand::StepForward, kFilm).frame, 9);
  EXPECT_EQ(moved_to({}, 1000, kFilm).frame, 9);
  EXPECT_EQ(moved_to({}, -4, kFilm).frame, 0);
}

TEST(Playback, follows_the_films_own_times) {
  EXPECT_EQ(advanced(playing(), 0.13, kFilm).frame, 3);
  EXPECT_EQ(advanced(playing(), 0.23, kFilm).frame, 3);  // the long picture
  EXPECT_EQ(advanced(playing(), 0.25, kFilm).frame, 4);
}

TEST(Playback, many_small_steps_of_time_are_one_large_one) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> step(0.001, 0.05);
  for (const LoopMode loop : {LoopMode::Once, LoopMode::Whole}) {
    for (const int shuttle : {1, -1, 2}) {
      Playback together = playing(4);
      together.loop = loop;
      together.shuttle = shuttle;
      Playback pieces = together;
      double elapsed = 0;
      for (int i = 0; i < 40; ++i) {
        const double by = step(random);
        elapsed += by;
        pieces = advanced(pieces, by, kFilm);
        const Playback jump = advanced(together, elapsed, kFilm);
        EXPECT_EQ(pieces.frame, jump.frame) << elapsed;
        EXPECT_NEAR(pieces.into_frame_s, jump.into_frame_s, 1e-9);
      }
    }
  }
}

TEST(Playback, slow_motion_takes_longer) {
  Playback slow = playing();
  slow.speed = 0.125;
  EXPECT_EQ(advanced(slow, 8 * 0.13, kFilm).frame, 3);
  EXPECT_EQ(advanced(slow, 0.3, kFilm).frame, 0);
}

TEST(Playback, stops_on_the_last_picture_and_starts_over_from_there) {
  Playback at = advanced(playing(), 99, kFilm);
  EXPECT_EQ(at.frame, 9);
  EXPECT_FALSE(at.is_playing);
  at = applied(at, PlaybackCommand::PlayPause, kFilm);
  EXPECT_EQ(at.frame, 0);
  EXPECT_TRUE(at.is_playing);
}

TEST(Playback, backwards_it_stops_on_the_first_picture) {
  Playback at = applied(playing(5), PlaybackCommand::ShuttleBack, kFilm);
  at = advanced(at, 99, kFilm);
  EXPECT_EQ(at.frame, 0);
  EXPECT_FALSE(at.is_playing);
}

TEST(Playback, shuttle_keys_double_the_speed_and_turn_round) {
  Playback at = applied({}, PlaybackCommand::ShuttleForward, kFilm);
  EXPECT_EQ(at.shuttle, 1);
  at = applied(at, PlaybackCommand::ShuttleForward, kFilm);
  EXPECT_EQ(at.shuttle, 2);
  at = applied(applied(at, PlaybackCommand::ShuttleForward, kFilm), PlaybackCommand::ShuttleForward, kFilm);
  EXPECT_EQ(at.shuttle, 4);
  at = applied(at, PlaybackCommand::ShuttleBack, kFilm);
  EXPECT_EQ(at.shuttle, -1);
  at = applied(at, PlaybackCommand::PlayPause, kFilm);
  EXPECT_FALSE(at.is_playing);
}

TEST(Playback, loops_between_the_marks) {
  Playback at = applied(moved_to({}, 6, kFilm), PlaybackCommand::MarkOut, kFilm);
  at = applied(moved_to(at, 4, kFilm), PlaybackCommand::MarkIn, kFilm);
  EXPECT_EQ(at.loop, LoopMode::Between);
  EXPECT_EQ(at.part(kFilm.count()), (Part{4, 6}));
  at = applied(at, PlaybackCommand::PlayPause, kFilm);
  for (int i = 0; i < 200; ++i) {
    at = advanced(at, 0.017, kFilm);
    EXPECT_GE(at.frame, 4);
    EXPECT_LE(at.frame, 6);
    EXPECT_TRUE(at.is_playing);
  }
  at = applied(at, PlaybackCommand::ClearMarks, kFilm);
  EXPECT_EQ(at.loop, LoopMode::Once);
}

TEST(Playback, marks_in_the_wrong_order_change_places) {
  Playback at = applied(moved_to({}, 3, kFilm), PlaybackCommand::MarkOut, kFilm);
  at = applied(moved_to(at, 7, kFilm), PlaybackCommand::MarkIn, kFilm);
  EXPECT_EQ(at.in, 3);
  EXPECT_EQ(at.out, 7);
}

TEST(Playback, goes_from_event_to_event) {
  Playback at;
  for (const int expected : {2, 5, 8, 9}) {
    at = applied(at, PlaybackCommand::NextEvent, kFilm);
    EXPECT_EQ(at.frame, expected);
  }
  for (const int expected : {8, 5, 2, 0}) {
    at = applied(at, PlaybackCommand::PreviousEvent, kFilm);
    EXPECT_EQ(at.frame, expected);
  }
}

TEST(Playback, speeds_stay_on_their_ladder) {
  Playback at;
  for (int i = 0; i < 20; ++i) at = applied(at, PlaybackCommand::Slower, kFilm);
  EXPECT_EQ(at.speed, 0.125);
  for (int i = 0; i < 20; ++i) at = applied(at, PlaybackCommand::Faster, kFilm);
  EXPECT_EQ(at.speed, 2);
  EXPECT_EQ(applied(at, PlaybackCommand::NormalSpeed, kFilm).speed, 1);
}

TEST(Playback, pictures_are_found_by_time) {
  EXPECT_EQ(frame_at(-1, kFilm), 0);
  EXPECT_EQ(frame_at(0.08, kFilm), 2);
  EXPECT_EQ(frame_at(0.2399, kFilm), 3);
  EXPECT_EQ(frame_at(7, kFilm), 9);
}

TEST(Playback, films_of_no_or_one_picture_do_nothing) {
  const std::vector<double> one = {0.5};
  for (const FilmMarks& film : {FilmMarks{}, FilmMarks{one, {}}})
    for (int command = 0; command <= static_cast<int>(PlaybackCommand::ClearMarks); ++command) {
      const Playback at =
          advanced(applied(playing(), static_cast<PlaybackCommand>(command), film), 1.5, film);
      EXPECT_EQ(at.frame, 0);
      EXPECT_FALSE(at.is_playing);
    }
}

// Whatever is pressed, the picture exists.
TEST(Playback, any_sequence_of_keys_leaves_a_valid_place) {
  std::mt19937 random(77);
  std::uniform_int_distribution<int> command(0, static_cast<int>(PlaybackCommand::ClearMarks));
  std::uniform_real_distribution<double> elapsed(0, 0.7);
  Playback at;
  for (int i = 0; i < 5000; ++i) {
    at = applied(at, static_cast<PlaybackCommand>(command(random)), kFilm);
    at = advanced(at, elapsed(random), kFilm);
    ASSERT_GE(at.frame, 0);
    ASSERT_LT(at.frame, kFilm.count());
    ASSERT_GE(at.into_frame_s, 0);
  }
}

}  // namespace
}  // namespace posecoach
