#include "core/pipeline/picture_coach.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "core/pipeline/analyze_picture.h"
#include "core/transfer/closed_form.h"
#include "tests/core/pipeline/bodies.h"
#include "tests/core/pipeline/filmed.h"

namespace posecoach {
namespace {

const Vec3 kFaceOn{0, 1.2, 4.2}, kDownTheLine{-4.2, 1.2, 0.3};
constexpr std::array kLimbs = {Landmark::LeftElbow,  Landmark::RightElbow, Landmark::LeftWrist,
                               Landmark::RightWrist, Landmark::LeftKnee,   Landmark::RightKnee,
                               Landmark::LeftAnkle,  Landmark::RightAnkle};

LiftedStudent lifted(const PoseTrack& track) {
  Result<LiftedStudent> student = lift(track);
  EXPECT_TRUE(student.has_value()) << (student ? "" : student.error().message);
  return *std::move(student);
}

// Mean distance in the student's picture between the carried coach and the student, hips in one place.
double apart_px(const Motion& carried, const LiftedStudent& student) {
  double sum = 0;
  int count = 0;
  const auto seen = [&](const Motion& motion, int frame, int joint) {
    return student.camera.project(motion.position(frame, joint)).value_or(Vec2{});
  };
  for (int frame = 0; frame < carried.frame_count(); frame += 3)
    for (const Landmark landmark : kLimbs) {
      const int joint = landmark_joint(landmark);
      sum += glm::distance(seen(carried, frame, joint) - seen(carried, frame, 0),
                           seen(student.motion, frame, joint) - seen(student.motion, frame, 0));
      ++count;
    }
  return sum / count;
}

TEST(PictureCoach, of_the_same_person_falls_on_his_own_picture) {
  const LiftedStudent person = lifted(film(tall_body(), kFaceOn, 50, {}).track);
  const auto ratio = make_closed_form_transferer(TransferMethod::Ratio);
  const auto coach = coach_in_picture(person, person, *ratio);
  ASSERT_TRUE(coach) << coach.error().message;
  EXPECT_EQ(coach->motion.skeleton(), person.body);
  for (int frame = 0; frame < coach->motion.frame_count(); frame += 7)
    for (const Landmark landmark : kLimbs) {
      const auto is = person.camera.project(coach->motion.position(frame, landmark_joint(landmark))),
                 was = person.camera.project(person.motion.position(frame, landmark_joint(landmark)));
      ASSERT_TRUE(is && was);
      EXPECT_LT(glm::distance(*is, *was), 0.5) << to_string(landmark) << " in frame " << frame;
    }
}

TEST(PictureCoach, of_other_bones_is_nearer_to_the_student_by_their_ratio_than_scaled) {
  const LiftedStudent coach = lifted(film(tall_body(), kFaceOn, 50, {}).track),
                      student = lifted(film(small_body(), kFaceOn, 50, {}).track);
  const auto ratio = make_closed_form_transferer(TransferMethod::Ratio),
             scale = make_closed_form_transferer(TransferMethod::Scale);
  const auto by_ratio = coach_in_picture(coach, student, *ratio),
             by_scale = coach_in_picture(coach, student, *scale);
  ASSERT_TRUE(by_ratio && by_scale);
  EXPECT_LT(apart_px(by_ratio->motion, student), 0.6 * apart_px(by_scale->motion, student));
}

TEST(PictureCoach, is_compared_like_any_other_coach) {
  const Filmed filmed = film(small_body(), kFaceOn, 50, {});
  const LiftedStudent student = lifted(filmed.track),
                      other = lifted(film(tall_body(), kFaceOn, 50, {}).track);
  const auto ratio = make_closed_form_transferer(TransferMethod::Ratio);
  const auto coach = coach_in_picture(other, student, *ratio);
  ASSERT_TRUE(coach);
  const auto pair = analyze(student_from_film("me", filmed.track, student), {"coach", coach->motion});
  ASSERT_TRUE(pair) << pair.error().message;
  EXPECT_GT(pair->analysis.score.percent, 85);
  EXPECT_FALSE(pair->analysis.student_events.empty());
  EXPECT_FALSE(pair->analysis.timing.empty());
}

TEST(PictureCoach, on_a_measured_body_stands_as_a_person_of_that_body_would) {
  const Filmed filmed = film(small_body(), kFaceOn, 50, {});
  const LiftedStudent other = lifted(film(tall_body(), kFaceOn, 50, {}).track);
  const auto ratio = make_closed_form_transferer(TransferMethod::Ratio);
  const auto coach = coach_on_body(other, small_body(), *ratio);
  ASSERT_TRUE(coach) << coach.error().message;
  ASSERT_EQ(coach->motion.frame_count(), filmed.truth.frame_count());
  double apart_m = 0;
  int count = 0;
  for (int frame = 0; frame < filmed.truth.frame_count(); frame += 3)
    for (const Landmark landmark : kLimbs) {
      const int joint = landmark_joint(landmark);
      const Vec3 off = (coach->motion.position(frame, joint) - coach->motion.position(frame, 0)) -
                       (filmed.truth.position(frame, joint) - filmed.truth.position(frame, 0));
      apart_m += std::hypot(off.x, off.y);
      ++count;
    }
  EXPECT_LT(apart_m / count, 0.05);
  const Skeleton stick = Skeleton::make({{"pelvis", kNoJoint, {}, HumanoidJoint::Pelvis}}).value();
  EXPECT_EQ(coach_on_body(other, stick, *ratio).error().code, ErrorCode::InvalidArgument);
}

TEST(PictureCoach, is_refused_from_another_side_in_words) {
  const LiftedStudent coach = lifted(film(tall_body(), kDownTheLine, 50, {}).track),
                      student = lifted(film(small_body(), kFaceOn, 50, {}).track);
  const auto ratio = make_closed_form_transferer(TransferMethod::Ratio);
  const auto refused = coach_in_picture(coach, student, *ratio);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::Incomplete);
  EXPECT_NE(refused.error().message.find("down-the-line"), std::string::npos) << refused.error().message;
}

TEST(PictureCoach, claims_nothing_about_joints_that_were_never_seen) {
  Filmed hidden = film(tall_body(), kFaceOn, 50, {});
  for (PoseObservation& frame : hidden.track.frames)
    for (const Landmark landmark :
         {Landmark::RightWrist, Landmark::RightIndex, Landmark::RightPinky, Landmark::RightThumb})
      frame.person->image[landmark].visibility = 0.1;
  const LiftedStudent student = lifted(film(small_body(), kFaceOn, 50, {}).track);
  const auto ratio = make_closed_form_transferer(TransferMethod::Ratio);
  const auto coach = coach_in_picture(lifted(hidden.track), student, *ratio);
  ASSERT_TRUE(coach) << coach.error().message;
  EXPECT_EQ(coach->motion.confidence(20, landmark_joint(Landmark::RightWrist)), 0);
  EXPECT_GT(coach->motion.confidence(20, landmark_joint(Landmark::LeftWrist)), 0.9);
  ASSERT_FALSE(coach->doubts.empty());
  EXPECT_NE(coach->doubts[0].find("right wrist"), std::string::npos) << coach->doubts[0];
}

TEST(PictureCoach, in_a_mirror_is_seen_mirrored_with_sides_exchanged) {
  const LiftedStudent person = lifted(film(tall_body(), {1.0, 1.2, 4}, 50, {}).track),
                      mirror = mirrored(person);
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    const Landmark landmark = static_cast<Landmark>(i);
    const auto was = person.camera.project(person.motion.position(15, landmark_joint(landmark))),
               is = mirror.camera.project(mirror.motion.position(15, landmark_joint(mirrored(landmark))));
    ASSERT_TRUE(was && is);
    EXPECT_NEAR(is->x, person.camera.width_px - was->x, 1e-6) << to_string(landmark);
    EXPECT_NEAR(is->y, was->y, 1e-6) << to_string(landmark);
  }
}

class OnePicture : public testing::Test {
 protected:
  static PoseTrack picture_of(const Filmed& filmed, std::size_t frame) {
    PoseTrack picture = filmed.track;
    picture.frames = {filmed.track.frames[frame]};
    return picture;
  }
  static Result<AnalyzedPair> analyzed(const Filmed& coach, std::size_t frame, const Filmed& student) {
    const Result<PoseTrack> still = still_film(picture_of(coach, frame));
    if (!still) return tl::unexpected(still.error());
    const LiftedStudent film = lifted(student.track);
    const auto ratio = make_closed_form_transferer(TransferMethod::Ratio);
    const auto carried = coach_in_picture(lifted(*still), film, *ratio);
    if (!carried) return tl::unexpected(carried.error());
    return analyze_picture(student_from_film("me", student.track, film), {"picture", carried->motion});
  }
};

TEST(AnalyzePicture, finds_a_pose_in_the_film_that_it_was_taken_from) {
  const Filmed filmed = film(tall_body(), kFaceOn, 50, {});
  const LiftedStudent student = lifted(filmed.track);
  std::vector<Vec3> still;
  for (int copy = 0; copy < 5; ++copy)
    still.insert(still.end(), student.motion.positions(25).begin(), student.motion.positions(25).end());
  const Motion picture = *Motion::from_positions(student.body, frame_times(5), still);
  const auto pair = analyze_picture(student_from_film("me", filmed.track, student), {"picture", picture});
  ASSERT_TRUE(pair) << pair.error().message;
  EXPECT_EQ(pair->analysis.path, (std::vector<std::pair<int, int>>{{25, 0}}));
  EXPECT_NEAR(pair->analysis.score.percent, 100, 1e-6);
  ASSERT_EQ(pair->analysis.advice.size(), 1U);
  EXPECT_EQ(pair->analysis.advice[0].kind, AdviceKind::None);
}

TEST_F(OnePicture, with_a_raised_hand_is_told_as_a_low_one) {
  Filmed coach = film(tall_body(), kFaceOn, 50, {});
  const Filmed student = coach;
  // Thirty centimetres and more at this distance.
  for (const Landmark landmark :
       {Landmark::LeftWrist, Landmark::LeftIndex, Landmark::LeftPinky, Landmark::LeftThumb})
    coach.track.frames[5].person->image[landmark].position_px.y -= 60;
  const auto pair = analyzed(coach, 5, student);
  ASSERT_TRUE(pair) << pair.error().message;
  ASSERT_FALSE(pair->analysis.spatial.empty());
  EXPECT_EQ(pair->analysis.spatial[0].joint, "left_wrist");
  EXPECT_NE(pair->analysis.spatial[0].advice.find("too low"), std::string::npos)
      << pair->analysis.spatial[0].advice;
  EXPECT_LT(pair->analysis.spatial[0].offset_m.y, -0.1);
}

TEST_F(OnePicture, without_anybody_is_an_error) {
  PoseTrack empty{"empty.jpg", 640, 480, {PoseObservation{}}};
  const auto still = still_film(empty);
  ASSERT_FALSE(still);
  EXPECT_EQ(still.error().code, ErrorCode::NoPerson);
  EXPECT_NE(still.error().message.find("empty.jpg"), std::string::npos);
}

}  // namespace
}  // namespace posecoach
