#include "core/pipeline/set_up_check.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/motion/bundled_motion.h"
#include "core/pipeline/coach_pipeline.h"
#include "tests/support/filmed_golfer.h"

namespace posecoach {
namespace {

using enum GolferPart::Kind;
using enum SetUpLevel;

// Grey, with a darker and a brighter half, so that there is something to see.
Image room(int width, int height, int grey, int contrast = 80) {
  Image image = Image::black(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c)
        image.pixel(x, y)[c] = static_cast<std::uint8_t>(
            std::clamp(grey + ((x / 8 + y / 8) % 2 == 0 ? contrast : -contrast) / 2, 0, 255));
  return image;
}

struct Room {
  GolferFilm film;
  Image image;
  std::optional<CameraSide> side = CameraSide{View::FaceOn, 0};
  std::optional<int> people = 1;
  std::optional<StrokeKind> stroke = StrokeKind::FullSwing;
  SetUpChecks checks;
  double clock_s = 0;
  std::vector<SetUpCheck> shown;

  explicit Room(const PinholeCamera& camera = face_on_camera(), int grey = 120, int contrast = 80)
      : film(film_golfer({.parts = {{Stand, 0.1}}}, camera)), image(room(1280, 720, grey, contrast)) {}

  const SetUpCheck& look(SetUpTopic topic, double seconds = 1) {
    for (double t = 0; t < seconds; t += 1 / 30.0) step(film.people[0]);
    return shown[static_cast<std::size_t>(topic)];
  }
  void step(const std::optional<SeenPerson>& person) {
    clock_s += 1 / 30.0;
    shown = checks.step(media_time_from_seconds(clock_s), {person, side, people, stroke, image});
  }
};

PinholeCamera camera_from(double distance, double up = 0) {
  return make_camera_looking_at({0, 0.9, distance}, {0, 0.95 + up, 0.1}, radians_from_degrees(54), 1280, 720);
}

TEST(SetUpChecks, a_golfer_who_stands_well_is_all_green) {
  Room room;
  room.look(SetUpTopic::View);
  ASSERT_EQ(room.shown.size(), 5U);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(room.shown[k].topic, static_cast<SetUpTopic>(k));
    EXPECT_EQ(room.shown[k].level, Good) << room.shown[k].words;
  }
}

TEST(SetUpChecks, an_empty_picture_asks_to_step_in) {
  Room room;
  for (int i = 0; i < 30; ++i) room.step(std::nullopt);
  EXPECT_EQ(room.shown[0].level, Bad);
  EXPECT_EQ(room.shown[0].words, "Step into the picture");
  for (const SetUpCheck& check : room.shown) EXPECT_NE(check.level, Good);
}

TEST(SetUpChecks, feet_that_are_cut_off_turn_amber) {
  Room room(camera_from(3.2, 0.75));
  const SetUpCheck& check = room.look(SetUpTopic::WholeBody);
  EXPECT_EQ(check.level, Poor);
  EXPECT_NE(check.words.find("feet"), std::string::npos) << check.words;
}

TEST(SetUpChecks, half_a_golfer_is_red) {
  Room room(camera_from(0.8));
  EXPECT_EQ(room.look(SetUpTopic::WholeBody).level, Bad);
}

TEST(SetUpChecks, distance_is_told_both_ways) {
  Room far(camera_from(9)), near(camera_from(1.4));
  EXPECT_EQ(far.look(SetUpTopic::Distance).words, "Too far away: come closer");
  EXPECT_EQ(near.look(SetUpTopic::Distance).words, "Too close for the club: step back");
}

TEST(SetUpChecks, darkness_and_flat_light_are_told) {
  Room dark(face_on_camera(), 20, 20), dim(face_on_camera(), 50, 60), flat(face_on_camera(), 120, 4);
  EXPECT_EQ(dark.look(SetUpTopic::Light).level, Bad);
  EXPECT_EQ(dim.look(SetUpTopic::Light).level, Poor);
  EXPECT_NE(flat.look(SetUpTopic::Light).words.find("background"), std::string::npos);
}

TEST(SetUpChecks, light_from_behind_is_told) {
  Room room(face_on_camera(), 200);
  for (int y = 0; y < 720; ++y)
    for (int x = 595; x < 685; ++x)
      for (int c = 0; c < 3; ++c) room.image.pixel(x, y)[c] /= 3;
  EXPECT_NE(room.look(SetUpTopic::Light).words.find("behind you"), std::string::npos) << room.shown[1].words;
}

TEST(SetUpChecks, two_people_are_one_too_many) {
  Room room;
  room.people = 2;
  EXPECT_EQ(room.look(SetUpTopic::OnePerson).level, Poor);
  room.people.reset();
  EXPECT_EQ(room.look(SetUpTopic::OnePerson).level, Good) << "a stage that cannot tell accuses nobody";
}

TEST(SetUpChecks, a_putt_wants_the_camera_in_front) {
  Room room;
  room.side = CameraSide{View::DownTheLine, 0};
  EXPECT_EQ(room.look(SetUpTopic::View).level, Good);
  room.stroke = StrokeKind::Putt;
  const SetUpCheck from_behind = room.look(SetUpTopic::View);
  EXPECT_EQ(from_behind.level, Poor);
  EXPECT_NE(from_behind.words.find("face-on"), std::string::npos) << from_behind.words;
  room.side = CameraSide{View::Between, 45};
  EXPECT_EQ(room.look(SetUpTopic::View).level, Poor);
}

TEST(SetUpChecks, a_camera_is_good_as_far_as_its_films_are_judged_in_full) {
  for (const View view : {View::FaceOn, View::DownTheLine})
    for (const double aside_deg : {-25.0, -9.0, 0.0, 9.0, 25.0}) {
      Room room;
      room.side = CameraSide{view, aside_deg};
      const SetUpCheck& check = room.look(SetUpTopic::View);
      EXPECT_EQ(check.level == Good, room.side->is_square()) << check.words;
    }
}

TEST(SetUpChecks, a_camera_a_little_aside_is_told_how_far_and_which_way) {
  const auto told = [](View view, double aside_deg) {
    Room room;
    room.side = CameraSide{view, aside_deg};
    return room.look(SetUpTopic::View).words;
  };
  EXPECT_EQ(told(View::FaceOn, 18), "About 20° off face-on: move the camera to your right");
  EXPECT_EQ(told(View::FaceOn, -18), "About 20° off face-on: move the camera to your left");
  EXPECT_NE(told(View::DownTheLine, 16), told(View::DownTheLine, -16));
  EXPECT_NE(told(View::DownTheLine, 16).find("15°"), std::string::npos);
}

TEST(SetUpChecks, a_camera_at_the_limit_does_not_flicker) {
  Room room;
  room.look(SetUpTopic::View);
  int changes = 0;
  for (int i = 0; i < 600; ++i) {
    room.side = CameraSide{View::FaceOn, kSquare_deg + (i % 60 < 30 ? 0.4 : -0.4)};
    const SetUpLevel before = room.shown[3].level;
    room.step(room.film.people[0]);
    if (room.shown[3].level != before) ++changes;
  }
  EXPECT_LE(changes, 1);
}

TEST(SetUpChecks, nothing_flickers) {
  Room room;
  room.look(SetUpTopic::OnePerson);
  int changes = 0;
  for (int i = 0; i < 300; ++i) {
    room.people = i % 6 < 3 ? 2 : 1;
    const SetUpLevel before = room.shown[2].level;
    room.step(room.film.people[0]);
    if (room.shown[2].level != before) ++changes;
  }
  EXPECT_EQ(changes, 0);
}

class CountingEstimator : public KnowingEstimator {
 public:
  using KnowingEstimator::KnowingEstimator;
  Result<std::optional<int>> count_people(const Frame&) override { return std::optional(2); }
};

TEST(SetUpChecks, the_pipeline_asks_the_pose_stage_for_other_people) {
  const auto film = std::make_shared<const GolferFilm>(
      film_golfer({.parts = {{Stand, 3}}}, face_on_camera(), kWebcamNoise));
  InlineWork work;
  CoachPipeline pipeline(std::make_unique<CountingEstimator>(film), work);
  CoachSnapshot last;
  for (std::size_t i = 0; i < film->count(); ++i) last = pipeline.step(film->frame(i)).value();
  ASSERT_EQ(last.checks.size(), 5U);
  EXPECT_EQ(last.checks[2].level, Poor);
  EXPECT_EQ(last.checks[0].level, Good) << last.checks[0].words;
}

TEST(AddressAdvice, the_coachs_own_posture_needs_none_and_only_at_address) {
  for (const bool left : {false, true})
    for (const PinholeCamera& camera : {face_on_camera(), down_the_line_camera(left)}) {
      const auto film = std::make_shared<const GolferFilm>(
          film_golfer({.is_left_handed = left, .parts = {{Stand, 6}}}, camera, kWebcamNoise));
      InlineWork work;
      CoachPipeline pipeline(std::make_unique<KnowingEstimator>(film), work);
      pipeline.set_person({.hand = left ? Handedness::Left : Handedness::Right});
      pipeline.set_coach(bundled_motion("swing").value(), "bundled:swing");
      CoachSnapshot last;
      for (std::size_t i = 0; i < film->count(); ++i) last = pipeline.step(film->frame(i)).value();
      EXPECT_TRUE(last.address_advice.empty()) << last.address_advice.front();
    }
}

}  // namespace
}  // namespace posecoach
