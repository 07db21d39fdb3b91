#include "ui/review/live_framing.h"

#include <gtest/gtest.h>

#include <memory>

namespace posecoach {
namespace {

using enum Landmark;

constexpr int kWidth = 1280, kHeight = 720;
constexpr double kShape = 16.0 / 9;

// Somebody this tall in a picture of 1280 x 720, his feet 60 pixels above its lower edge.
CoachSnapshot snapshot_of(double height_px, double across_px = 640) {
  CoachSnapshot snapshot;
  snapshot.source_state = SourceState::Live;
  snapshot.frame = Frame{0, {}, {}, std::make_shared<const Image>(Image::black(kWidth, kHeight))};
  SeenPerson person;
  const double feet = kHeight - 60;
  person.image[Nose] = {{across_px, feet - 0.93 * height_px}, 0.9};
  for (const Landmark hip : {LeftHip, RightHip})
    person.image[hip] = {{across_px + (hip == LeftHip ? 15 : -15), feet - 0.5 * height_px}, 0.9};
  for (const Landmark heel : {LeftHeel, RightHeel})
    person.image[heel] = {{across_px + (heel == LeftHeel ? 30 : -30), feet}, 0.9};
  snapshot.person = person;
  return snapshot;
}

PicturePart settled(LiveFraming framing, const CoachSnapshot& snapshot) {
  for (int i = 0; i < 200; ++i) framing = framed(framing, snapshot, kShape, 1.0 / 30);
  return framing.part;
}

void expect_near(const PicturePart& part, const PicturePart& wanted) {
  for (int axis = 0; axis < 2; ++axis) {
    EXPECT_NEAR(part.begin[axis], wanted.begin[axis], 1e-3);
    EXPECT_NEAR(part.end[axis], wanted.end[axis], 1e-3);
  }
}

TEST(LiveFraming, a_small_golfer_is_shown_larger_whole_and_in_the_pictures_own_shape) {
  const CoachSnapshot snapshot = snapshot_of(320, 700);
  const PicturePart part = framed({}, snapshot, kShape, 0).part;
  const Vec2 size = part.size() * Vec2(kWidth, kHeight);
  EXPECT_NEAR(size.x / size.y, kShape, 1e-6);
  EXPECT_LT(part.size().y, 0.75);
  EXPECT_GT(part.size().y * kHeight, 1.3 * 320);  // room for the club
  for (const Landmark landmark : {Nose, LeftHeel, RightHeel}) {
    const Vec2 at = snapshot.person->image[landmark].position_px / Vec2(kWidth, kHeight);
    EXPECT_GT(at.x, part.begin.x);
    EXPECT_LT(at.x, part.end.x);
    EXPECT_GT(at.y, part.begin.y);
    EXPECT_LT(at.y, part.end.y);
  }
}

TEST(LiveFraming, who_fills_the_picture_sees_all_of_it) {
  expect_near(framed({}, snapshot_of(600), kShape, 0).part, {});
}

TEST(LiveFraming, the_whole_picture_is_shown_while_the_camera_does_not_see_all_of_him) {
  CoachSnapshot snapshot = snapshot_of(320);
  snapshot.checks = {{SetUpTopic::WholeBody, SetUpLevel::Poor, "Your feet are not seen."}};
  expect_near(framed({}, snapshot, kShape, 0).part, {});
}

TEST(LiveFraming, bending_and_trembling_move_nothing_walking_away_does) {
  const LiveFraming framing = framed({}, snapshot_of(320, 640), kShape, 0);
  expect_near(settled(framing, snapshot_of(300, 655)), framing.part);
  const PicturePart followed = settled(framing, snapshot_of(320, 900));
  EXPECT_GT(0.5 * (followed.begin.x + followed.end.x), 0.62);
}

TEST(LiveFraming, nothing_moves_during_a_swing) {
  const LiveFraming framing = framed({}, snapshot_of(320, 640), kShape, 0);
  CoachSnapshot swinging = snapshot_of(250, 900);
  swinging.loop = LoopState::Swinging;
  expect_near(settled(framing, swinging), framing.part);
}

TEST(LiveFraming, it_goes_back_to_the_whole_picture_once_he_is_gone) {
  const LiveFraming framing = framed({}, snapshot_of(320), kShape, 0);
  CoachSnapshot nobody = snapshot_of(320);
  nobody.person.reset();
  expect_near(framed(framing, nobody, kShape, 0.5).part, framing.part);
  expect_near(settled(framing, nobody), {});
}

TEST(LiveFraming, thin_bars_are_cut_off_and_wide_ones_stay) {
  EXPECT_NEAR(whole_part(kWidth, kHeight, 1.72).size().x, 1.72 / kShape, 1e-9);
  EXPECT_NEAR(whole_part(kWidth, kHeight, 1.82).size().y, kShape / 1.82, 1e-9);
  expect_near(whole_part(720, 1280, kShape), {});
}

}  // namespace
}  // namespace posecoach
