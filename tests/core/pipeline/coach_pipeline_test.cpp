#include "core/pipeline/coach_pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/body/body_measurement.h"
#include "core/body/landmark_body.h"
#include "core/motion/bundled_motion.h"
#include "tests/support/filmed_golfer.h"

namespace posecoach {
namespace {

using enum GolferPart::Kind;

struct Live {
  std::shared_ptr<const GolferFilm> film;
  InlineWork work;
  CoachPipeline pipeline;

  explicit Live(GolferFilm golfer)
      : film(std::make_shared<const GolferFilm>(std::move(golfer))),
        pipeline(std::make_unique<KnowingEstimator>(film), work) {}

  void set_coach(const std::string& name) {
    pipeline.set_coach(bundled_motion(name).value(), "bundled:" + name);
  }
  CoachSnapshot step(std::size_t index) { return pipeline.step(film->frame(index)).value(); }
  // All frames; every snapshot.
  std::vector<CoachSnapshot> play() {
    std::vector<CoachSnapshot> snapshots;
    for (std::size_t i = 0; i < film->count(); ++i) snapshots.push_back(step(i));
    return snapshots;
  }
};

double pixels_apart(const PinholeCamera& camera, const Vec3& world, const Vec2& seen) {
  const std::optional<Vec2> projected = camera.project(world);
  return projected ? glm::distance(*projected, seen) : 1e9;
}

TEST(CoachPipeline, the_students_joints_fall_on_their_picture_from_the_first_frame) {
  for (const PinholeCamera& camera : {face_on_camera(), down_the_line_camera(false)}) {
    Live live(film_golfer({.parts = {{Stand, 0.5}, {Stroke}}}, camera, kWebcamNoise));
    for (std::size_t i = 0; i < live.film->count(); ++i) {
      const CoachSnapshot snapshot = live.step(i);
      ASSERT_TRUE(snapshot.student && snapshot.camera && snapshot.person) << i;
      for (std::size_t k = 0; k < kLandmarkCount; ++k)
        EXPECT_LT(pixels_apart(*snapshot.camera, snapshot.student->positions[k + kLandmarkBodyDerivedJoints],
                               snapshot.person->image[k].position_px),
                  0.5);
    }
  }
}

TEST(CoachPipeline, the_ghost_stands_on_the_students_feet_in_his_body) {
  for (const bool left : {false, true})
    for (const PinholeCamera& camera : {face_on_camera(), down_the_line_camera(left)}) {
      Live live(film_golfer({.is_left_handed = left, .parts = {{Stand, 5}}}, camera, kWebcamNoise));
      live.set_coach("swing");
      live.pipeline.set_person({.hand = left ? Handedness::Left : Handedness::Right});
      const CoachSnapshot snapshot = live.play().back();
      ASSERT_TRUE(snapshot.ghost);
      const BodyPose& ghost = snapshot.ghost->body;
      for (const HumanoidJoint joint : {HumanoidJoint::LeftAnkle, HumanoidJoint::RightAnkle}) {
        const auto j = static_cast<std::size_t>(ghost.skeleton->find(joint));
        EXPECT_LT(glm::distance(ghost.positions[j], snapshot.student->positions[j]), 0.10)
            << to_string(joint);
      }
      for (std::size_t j = 1; j < ghost.positions.size(); ++j) {
        const Joint& bone = ghost.skeleton->joint(static_cast<int>(j));
        EXPECT_NEAR(glm::distance(ghost.positions[j], ghost.positions[static_cast<std::size_t>(bone.parent)]),
                    ghost.skeleton->bone_length(static_cast<int>(j)), 0.01)
            << bone.name;
      }
    }
}

TEST(CoachPipeline, a_person_who_leaves_clears_the_skeletons_within_half_a_second) {
  Live live(film_golfer({.parts = {{Stand, 2}, {Away, 2}, {Stand, 3}}}, face_on_camera(), kWebcamNoise));
  live.set_coach("swing");
  const std::vector<CoachSnapshot> snapshots = live.play();
  EXPECT_TRUE(snapshots[59].student && snapshots[59].ghost);
  for (std::size_t i = 75; i < 120; ++i) EXPECT_FALSE(snapshots[i].student || snapshots[i].ghost) << i;
  EXPECT_TRUE(snapshots.back().student && snapshots.back().ghost);
}

TEST(CoachPipeline, the_body_is_measured_after_a_count_down_and_the_coach_moves_into_it) {
  Live live(film_golfer({.parts = {{TPose, 12}}}, face_on_camera(), kWebcamNoise));
  live.set_coach("swing");
  live.pipeline.set_person({.height_m = 1.83});
  for (std::size_t i = 0; i < 30; ++i) live.step(i);
  live.pipeline.start_measuring();
  std::vector<Measuring::Stage> stages;
  CoachSnapshot snapshot;
  for (std::size_t i = 30; i < live.film->count(); ++i) {
    snapshot = live.step(i);
    if (snapshot.measuring && (stages.empty() || stages.back() != snapshot.measuring->stage))
      stages.push_back(snapshot.measuring->stage);
  }
  using enum Measuring::Stage;
  EXPECT_EQ(stages, (std::vector{CountDown, Looking, Done}));
  EXPECT_FALSE(snapshot.measuring) << "the answer goes away by itself";
  ASSERT_TRUE(snapshot.measured_body);
  EXPECT_NEAR(stature(*snapshot.measured_body), 1.83, 1e-6);
  ASSERT_TRUE(snapshot.ghost);
  EXPECT_TRUE(*snapshot.ghost->body.skeleton == *snapshot.measured_body);
}

TEST(CoachPipeline, measuring_nobody_fails_with_what_to_do) {
  Live live(film_golfer({.parts = {{Stand, 1}, {Away, 8}}}, face_on_camera()));
  live.pipeline.start_measuring();
  std::optional<Measuring> last;
  for (const CoachSnapshot& snapshot : live.play())
    if (snapshot.measuring) last = snapshot.measuring;
  ASSERT_TRUE(last);
  EXPECT_EQ(last->stage, Measuring::Stage::Failed);
  EXPECT_NE(last->words.find("try again"), std::string::npos);
}

TEST(CoachPipeline, a_finish_that_is_held_does_not_turn_the_camera_aside) {
  Live live(film_golfer({.parts = {{Stand, 2}, {Stroke}, {Finish, 4}}}, face_on_camera()));
  const SetUpCheck* last = nullptr;
  const std::vector<CoachSnapshot> snapshots = live.play();
  for (const SetUpCheck& check : snapshots.back().checks)
    if (check.topic == SetUpTopic::View) last = &check;
  ASSERT_NE(last, nullptr);
  EXPECT_EQ(last->level, SetUpLevel::Good) << last->words;
}

TEST(CoachPipeline, the_same_frames_give_the_same_snapshots) {
  const GolferFilm film = film_golfer({.parts = {{Stand, 2}, {Stroke}}}, face_on_camera(), kWebcamNoise);
  const auto last_of = [&] {
    Live live(film);
    live.set_coach("swing");
    return live.play().back();
  };
  const CoachSnapshot a = last_of(), b = last_of();
  EXPECT_EQ(a.student->positions, b.student->positions);
  EXPECT_EQ(a.ghost->body.positions, b.ghost->body.positions);
  EXPECT_EQ(a.ghost->closeness, b.ghost->closeness);
}

}  // namespace
}  // namespace posecoach
