// A coach of whom there are only pictures, through the live pipeline.
#include "core/pipeline/filmed_coach.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/pipeline/coach_pipeline.h"
#include "core/pipeline/picture_coach.h"
#include "core/transfer/closed_form.h"
#include "tests/core/pipeline/bodies.h"
#include "tests/core/pipeline/filmed.h"
#include "tests/support/filmed_golfer.h"

namespace posecoach {
namespace {

using enum GolferPart::Kind;
using testing::HasSubstr;

const Vec3 kFaceOn{0, 1.2, 4.2}, kDownTheLine{-4.2, 1.2, 0.3};
constexpr std::array kLimbs = {HumanoidJoint::LeftElbow,  HumanoidJoint::RightElbow, HumanoidJoint::LeftWrist,
                               HumanoidJoint::RightWrist, HumanoidJoint::LeftKnee,   HumanoidJoint::RightKnee,
                               HumanoidJoint::LeftAnkle,  HumanoidJoint::RightAnkle};

Result<std::unique_ptr<Transferer>> ratio() {
  return make_closed_form_transferer(TransferMethod::Ratio);
}

FilmedCoach coach_from(const PoseTrack& pictures) {
  Result<FilmedCoach> coach = filmed_coach_from(pictures, ratio);
  EXPECT_TRUE(coach) << coach.error().message;
  return *std::move(coach);
}

// The bundled swing on a long-legged coach.
PoseTrack coach_film(const Vec3& eye = kFaceOn) {
  return film(tall_body(), eye, 50, {}).track;
}

PoseTrack one_picture(PoseTrack film, std::size_t frame) {
  film.frames = {film.frames[frame]};
  return film;
}

void hide(PoseTrack& track, std::initializer_list<Landmark> landmarks) {
  for (PoseObservation& frame : track.frames)
    for (const Landmark landmark : landmarks) frame.person->image[landmark].visibility = 0.1;
}

struct Live {
  std::shared_ptr<const GolferFilm> film;
  InlineWork work;
  CoachPipeline pipeline;
  std::vector<CoachSnapshot> snapshots;

  Live(const GolferScript& script, const PinholeCamera& camera, const PoseTrack& coach)
      : film(std::make_shared<const GolferFilm>(film_golfer(script, scaled(camera, 0.25)))),
        pipeline(std::make_unique<KnowingEstimator>(film), work) {
    pipeline.set_person({.hand = script.is_left_handed ? Handedness::Left : Handedness::Right});
    pipeline.set_coach(coach_from(coach));
  }
  Live& play() {
    for (std::size_t i = 0; i < film->count(); ++i)
      snapshots.push_back(pipeline.step(film->frame(i)).value());
    return *this;
  }
  const CoachSnapshot& at(double time_s) const {
    const auto first = std::find_if(film->times.begin(), film->times.end(),
                                    [&](MediaTime time) { return to_seconds(time) >= time_s; });
    return snapshots[static_cast<std::size_t>(first - film->times.begin())];
  }
};

std::optional<Vec2> seen_at(const CoachSnapshot& snapshot, const BodyPose& body, HumanoidJoint joint) {
  return snapshot.camera->project(body.positions[static_cast<std::size_t>(body.skeleton->find(joint))]);
}

// Mean distance of the limbs in the picture between ghost and student, as a part of the student's height in
// it.
double apart(const CoachSnapshot& snapshot) {
  double sum = 0;
  for (const HumanoidJoint joint : kLimbs)
    sum += glm::distance(*seen_at(snapshot, snapshot.ghost->body, joint),
                         *seen_at(snapshot, *snapshot.student, joint));
  const double height = glm::distance(*seen_at(snapshot, *snapshot.student, HumanoidJoint::Head),
                                      *seen_at(snapshot, *snapshot.student, HumanoidJoint::LeftAnkle));
  return sum / kLimbs.size() / height;
}

TEST(FilmedCoach, follows_the_student_on_his_picture_in_his_proportions) {
  for (const bool is_left_handed : {false, true}) {
    // The student swings as the coach does: so where his shape is the student's, the two are one.
    Live live({.is_left_handed = is_left_handed, .parts = {{Stand, 5}, {Stroke}, {Stand, 1}}},
              face_on_camera(), coach_film());
    live.play();
    const double begin = live.film->stroke_begin_s[0], end = live.film->stroke_end_s[0];
    double sum = 0;
    int count = 0;
    for (double time = begin; time < end; time += 0.1, ++count) {
      ASSERT_TRUE(live.at(time).ghost) << time;
      sum += apart(live.at(time));
    }
    EXPECT_LT(sum / count, 0.06) << is_left_handed;
    EXPECT_LT(apart(live.at(begin - 0.2)), 0.04) << is_left_handed;
    EXPECT_LT(live.at(begin - 0.2).ghost->fraction, 0.3);
    EXPECT_GT(live.snapshots.back().ghost->fraction, 0.7);
    EXPECT_EQ(live.snapshots.back().coach_message, "");
  }
}

TEST(FilmedCoach, of_a_single_picture_is_a_target_that_stands_still) {
  const PoseTrack film = coach_film();
  const std::size_t top = film.frames.size() / 3;
  Live live({.parts = {{Stand, 5}, {Stroke}, {Stand, 1}}}, face_on_camera(), one_picture(film, top));
  live.play();
  const std::vector<Vec3>& target = live.at(4).ghost->body.positions;
  double nearest = 1e9;
  for (const CoachSnapshot& snapshot : live.snapshots) {
    if (to_seconds(snapshot.frame->time) < 4) continue;
    ASSERT_TRUE(snapshot.ghost);
    for (std::size_t j = 0; j < target.size(); ++j)
      ASSERT_LT(glm::distance(snapshot.ghost->body.positions[j], target[j]), 0.03);
    nearest = std::min(nearest, apart(snapshot));
  }
  EXPECT_LT(nearest, 0.06) << "he passes through the pose";
  EXPECT_GT(apart(live.at(4)), 2 * nearest);
}

TEST(FilmedCoach, leaves_out_what_was_not_seen_and_says_so) {
  PoseTrack film = coach_film();
  hide(film, {Landmark::RightWrist, Landmark::RightIndex, Landmark::RightPinky, Landmark::RightThumb});
  Live live({.parts = {{Stand, 5}}}, face_on_camera(), film);
  const CoachSnapshot last = live.play().snapshots.back();
  ASSERT_TRUE(last.ghost);
  const BodyPose& ghost = last.ghost->body;
  const auto confidence = [&](HumanoidJoint joint) {
    return ghost.confidence[static_cast<std::size_t>(ghost.skeleton->find(joint))];
  };
  EXPECT_EQ(confidence(HumanoidJoint::RightWrist), 0);
  EXPECT_GT(confidence(HumanoidJoint::LeftWrist), 0.9);
  EXPECT_LT(last.ghost->closeness[static_cast<std::size_t>(HumanoidJoint::RightWrist)], 0) << "unknown";
  EXPECT_GT(last.ghost->closeness[static_cast<std::size_t>(HumanoidJoint::LeftWrist)], 0.5);
  EXPECT_THAT(last.coach_message, HasSubstr("right wrist"));
}

TEST(FilmedCoach, seen_from_another_side_is_not_drawn_but_said) {
  Live live({.parts = {{Stand, 5}}}, face_on_camera(), coach_film(kDownTheLine));
  const CoachSnapshot last = live.play().snapshots.back();
  EXPECT_TRUE(last.student);
  EXPECT_FALSE(last.ghost);
  EXPECT_THAT(last.coach_message, HasSubstr("stand so that the camera sees you down-the-line"));
}

TEST(FilmedCoach, is_compared_with_each_swing) {
  Live live({.parts = {{Stand, 5}, {Stroke}, {Stand, 2}}}, face_on_camera(), coach_film());
  live.pipeline.arm();
  const CoachSnapshot last = live.play().snapshots.back();
  ASSERT_TRUE(last.swing) << last.swing_message;
  const Analysis& analysis = last.swing->pair.analysis;
  EXPECT_EQ(analysis.retarget_method, kTransfer2d);
  EXPECT_GT(analysis.score.percent, 80) << "the coach's own swing";
  EXPECT_FALSE(analysis.timing.empty());
}

TEST(FilmedCoach, of_a_single_picture_is_compared_with_the_moment_that_is_most_like_it) {
  const PoseTrack film = coach_film();
  const std::size_t top = film.frames.size() / 3;
  Live live({.parts = {{Stand, 5}, {Stroke}, {Stand, 2}}}, face_on_camera(), one_picture(film, top));
  live.pipeline.arm();
  const CoachSnapshot last = live.play().snapshots.back();
  ASSERT_TRUE(last.swing) << last.swing_message;
  const Analysis& analysis = last.swing->pair.analysis;
  ASSERT_EQ(analysis.path.size(), 1U);
  EXPECT_TRUE(analysis.timing.empty());
  // The track is a cut of the film: the frame with those very joints.
  const PoseObservation& found = last.swing->track.frames[static_cast<std::size_t>(analysis.path[0].first)];
  const auto& people = live.film->people;
  const auto same = std::find_if(people.begin(), people.end(), [&](const std::optional<SeenPerson>& person) {
    return person && person->image[Landmark::LeftWrist].position_px ==
                         found.person->image[Landmark::LeftWrist].position_px;
  });
  ASSERT_NE(same, people.end());
  EXPECT_NEAR(to_seconds(live.film->times[static_cast<std::size_t>(same - people.begin())]),
              live.film->stroke_begin_s[0] + static_cast<double>(top) / 30, 0.15);
}

TEST(FilmedCoach, gives_way_to_another_coach) {
  Live live({.parts = {{Stand, 6}}}, face_on_camera(), coach_film(kDownTheLine));
  for (std::size_t i = 0; i < 150; ++i) (void)live.pipeline.step(live.film->frame(i));
  live.pipeline.set_coach(bundled_motion("swing").value(), "bundled:swing");
  const CoachSnapshot after = live.pipeline.step(live.film->frame(150)).value();
  EXPECT_TRUE(after.ghost);
  EXPECT_EQ(after.coach_message, "");
}

TEST(FilmedCoach, of_whom_nothing_is_seen_is_an_error) {
  PoseTrack film = coach_film();
  for (PoseObservation& frame : film.frames) frame.person.reset();
  EXPECT_EQ(filmed_coach_from(film, ratio).error().code, ErrorCode::NoPerson);
}

TEST(FilmedCoach, a_picture_from_the_middle_of_a_stroke_does_not_tell_its_side) {
  const PoseTrack film = coach_film();
  EXPECT_EQ(coach_from(one_picture(film, 0)).lifted.view, View::FaceOn);
  EXPECT_EQ(coach_from(one_picture(film, film.frames.size() - 1)).lifted.view, View::Between) << "the finish";
}

}  // namespace
}  // namespace posecoach
