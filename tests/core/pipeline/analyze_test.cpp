#include "core/pipeline/analyze.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/body/standard_body.h"
#include "core/coaching/compare.h"
#include "core/coaching/text/advice_text.h"
#include "core/motion/authored/golf_fault.h"
#include "core/motion/bundled_motion.h"
#include "tests/core/pipeline/bodies.h"
#include "tests/core/pipeline/filmed.h"

namespace posecoach {
namespace {

Motion swing_on(const BodyProportions& body, double fps, Handedness hand = Handedness::Right,
                const GolfScript& script = bundled_script("swing").value()) {
  return make_authored_motion(script, make_standard_body(body), fps, hand).value().motion;
}

AnalyzedPair analyzed(const Motion& student, const Motion& coach, const AnalyzeOptions& options = {}) {
  Result<AnalyzedPair> pair = analyze(student_from_motion("student", student), {"coach", coach}, options);
  EXPECT_TRUE(pair.has_value()) << (pair ? "" : pair.error().message);
  return *std::move(pair);
}

// The poses of one golfer carried over to other bones: the same motion, another body.
Motion same_motion_on(const Motion& coach, const BodyProportions& body) {
  return retarget(coach, make_standard_body(body)).value().motion;
}

TEST(Analyze, the_same_motion_scores_alike_on_every_body_and_worse_when_not_personalised) {
  const Motion coach = swing_on({.height_m = 1.8}, 120);
  const std::vector<BodyProportions> bodies = {{.height_m = 1.5},
                                               {.height_m = 2.0},
                                               {.height_m = 1.75, .arms = 1.25},
                                               {.height_m = 1.75, .arms = 0.8, .thighs = 1.2},
                                               {.height_m = 1.6, .torso = 1.2, .shins = 0.8}};
  for (const BodyProportions& body : bodies) {
    const Motion student = same_motion_on(coach, body);
    AnalyzeOptions plain;
    plain.retarget.contacts = Contacts::Off;
    EXPECT_GE(analyzed(student, coach, plain).analysis.score.percent, 98) << body.height_m << " m";
    const Result<Analysis> as_it_is = compare(student, coach);
    ASSERT_TRUE(as_it_is);
    EXPECT_LT(as_it_is->score.percent, 95) << body.height_m << " m";
  }
}

// As golfers of these bodies swing, not as the coach's motion would be carried over to them.
TEST(Analyze,
     the_same_swing_of_another_golfer_scores_within_two_points_in_his_body_and_clearly_worse_without) {
  const Motion coach = swing_on({.height_m = 1.8}, 120);
  const std::vector<BodyProportions> bodies = {
      {.height_m = 1.5},
      {.height_m = 2.0},
      {.height_m = 1.7, .arms = 1.25},
      {.height_m = 1.75, .arms = 0.8},
      {.height_m = 1.8, .torso = 0.85, .thighs = 1.25, .shins = 1.25},
      {.height_m = 1.7, .torso = 1.15, .thighs = 0.75, .shins = 0.75}};
  for (const BodyProportions& body : bodies) {
    const Motion student = swing_on(body, 60);
    const double in_his_body = analyzed(student, coach).analysis.score.percent;
    EXPECT_GE(in_his_body, 98) << body.height_m << " m, arms " << body.arms << ", legs " << body.thighs;
    const Result<Analysis> as_it_is = compare(student, coach);
    ASSERT_TRUE(as_it_is);
    EXPECT_LT(as_it_is->score.percent, in_his_body - 4)
        << body.height_m << " m, arms " << body.arms << ", legs " << body.thighs;
  }
}

TEST(Analyze, a_motion_against_itself_has_a_raw_score_of_zero) {
  const Motion swing = swing_on({.height_m = 1.7, .arms = 1.1}, 60);
  const Analysis analysis = analyzed(swing, swing).analysis;
  EXPECT_EQ(analysis.score.raw, 0);
  EXPECT_EQ(analysis.score.percent, 100);
  ASSERT_EQ(analysis.advice.size(), 1U);
  EXPECT_EQ(analysis.advice[0].kind, AdviceKind::None);
}

TEST(Analyze, fills_in_sources_method_and_bone_lengths) {
  const Motion coach = swing_on({.height_m = 1.8}, 60), student = swing_on({.height_m = 1.65}, 30);
  const Analysis analysis = analyzed(student, coach).analysis;
  EXPECT_EQ(analysis.coach.source, "coach");
  EXPECT_EQ(analysis.student.source, "student");
  EXPECT_EQ(analysis.retarget_method, to_string(kDefaultRetargetMethod));
  EXPECT_TRUE(analysis.contacts);
  EXPECT_LT(analysis.bone_length_error_max, 1e-3);
  EXPECT_EQ(analysis.student.frames, student.frame_count());
}

TEST(Analyze, counts_frames_and_times_as_the_film_does) {
  const Motion coach = swing_on({}, 120), student = swing_on({}, 30);
  StudentInput film = student_from_motion("film", student);
  film.first_frame = 12;
  film.first_time_s = 0.4;
  const Result<AnalyzedPair> later = analyze(film, {"coach", coach});
  ASSERT_TRUE(later);
  const Analysis plain = analyzed(student, coach).analysis;
  EXPECT_EQ(later->analysis.path.front().first, plain.path.front().first + 12);
  EXPECT_EQ(later->analysis.student_events[3].frame, plain.student_events[3].frame + 12);
  EXPECT_NEAR(later->analysis.student_events[3].time_s, plain.student_events[3].time_s + 0.4, 1e-9);
}

TEST(Analyze, places_the_coach_on_the_students_feet_facing_as_he_does) {
  const Motion coach = swing_on({.height_m = 1.85}, 120);
  const Motion student = swing_on({.height_m = 1.7}, 30);
  // Elsewhere on the floor and turned.
  std::vector<Vec3> positions;
  for (int frame = 0; frame < student.frame_count(); ++frame)
    for (const Vec3& p : student.positions(frame)) positions.push_back(Vec3(p.z, p.y, -p.x) + Vec3(3, 0, -2));
  const Motion elsewhere =
      Motion::from_positions(student.skeleton(), {student.times().begin(), student.times().end()}, positions)
          .value();
  const AnalyzedPair pair = analyzed(elsewhere, coach);
  const auto& [student_frame, coach_frame] = pair.analysis.path.front();
  for (const HumanoidJoint joint :
       {HumanoidJoint::LeftAnkle, HumanoidJoint::RightAnkle, HumanoidJoint::Pelvis}) {
    const Vec3 his = elsewhere.position(student_frame, elsewhere.skeleton().find(joint));
    const Vec3 coachs = pair.coach.position(coach_frame, pair.coach.skeleton().find(joint));
    EXPECT_LT(glm::distance(his, coachs), 0.06) << to_string(joint);
  }
}

TEST(Analyze, gives_a_left_hander_the_numbers_of_his_mirror_image) {
  GolfScript script = bundled_script("swing").value();
  ASSERT_TRUE(apply_fault(script, choose_fault("sway").value()));
  const Motion coach = swing_on({.height_m = 1.8}, 120);
  const Motion right = swing_on({.height_m = 1.65}, 30, Handedness::Right, script), left = mirrored(right);
  const AnalyzedPair of_right = analyzed(right, coach), of_left = analyzed(left, coach);
  EXPECT_EQ(of_left.analysis.student.hand, Handedness::Left);
  EXPECT_NEAR(of_left.analysis.score.raw, of_right.analysis.score.raw, 1e-9);
  EXPECT_EQ(of_left.analysis.path, of_right.analysis.path);
  ASSERT_EQ(of_left.analysis.advice.size(), of_right.analysis.advice.size());
  for (std::size_t k = 0; k < of_left.analysis.advice.size(); ++k)
    EXPECT_EQ(of_left.analysis.advice[k].text, of_right.analysis.advice[k].text);
  ASSERT_EQ(of_left.analysis.metrics.size(), of_right.analysis.metrics.size());
  for (std::size_t k = 0; k < of_left.analysis.metrics.size(); ++k)
    EXPECT_NEAR(of_left.analysis.metrics[k].value, of_right.analysis.metrics[k].value, 1e-6)
        << of_left.analysis.metrics[k].name;
  // What is drawn is named as it is on his body.
  ASSERT_EQ(of_left.analysis.poses.size(), of_right.analysis.poses.size());
  for (std::size_t k = 0; k < of_left.analysis.poses.size(); ++k) {
    const auto &left_gaps = of_left.analysis.poses[k].joints, &right_gaps = of_right.analysis.poses[k].joints;
    ASSERT_EQ(left_gaps.size(), right_gaps.size());
    for (std::size_t j = 0; j < left_gaps.size(); ++j) {
      EXPECT_EQ(left_gaps[j].joint, to_string(mirrored(*humanoid_joint_from_string(right_gaps[j].joint))));
      EXPECT_NEAR(left_gaps[j].offset_m.x, -right_gaps[j].offset_m.x, 1e-6);
    }
  }
  const Vec3 drawn = of_left.coach.position(10, 3), mirror = mirrored(of_right.coach).position(10, 3);
  EXPECT_LT(glm::distance(drawn, mirror), 1e-6);
}

TEST(Analyze, names_a_fault_on_a_body_that_is_not_the_coachs) {
  GolfScript script = bundled_script("swing").value();
  ASSERT_TRUE(apply_fault(script, choose_fault("sway").value()));
  const Motion student = swing_on({.height_m = 1.62, .arms = 1.1}, 30, Handedness::Right, script);
  const Analysis analysis = analyzed(student, swing_on({.height_m = 1.8}, 120)).analysis;
  EXPECT_NE(analysis.advice[0].text.find("At the top, your hips"), std::string::npos)
      << analysis.advice[0].text;
}

// A pose model that is wrong as real ones are: alike for everybody, and by how far or near a joint is.
PoseTrack with_habits(PoseTrack track) {
  for (PoseObservation& frame : track.frames)
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
      const double depth = frame.person->world[i].position_m.z;
      frame.person->image[i].position_px += depth * Vec2(70, -60);
      frame.person->world[i].position_m += depth * Vec3(0.25, -0.2, 0.4);
    }
  return track;
}

StudentInput filmed_student(const PoseTrack& track) {
  return student_from_film("film", track, lift(track).value());
}

TEST(Analyze, does_not_tell_a_golfer_what_the_camera_got_wrong_of_him_and_of_his_filmed_coach) {
  const Vec3 face_on(0, 1.1, 4);
  const StudentInput student =
                         filmed_student(with_habits(film(test_landmark_body(0.9), face_on, 45, {}).track)),
                     coach =
                         filmed_student(with_habits(film(test_landmark_body(1.1), face_on, 45, {}).track));
  ASSERT_EQ(student.view, Viewpoint::FaceOn);
  const Analysis against_film = analyze(student, {"coach's film", coach.motion}).value().analysis;
  EXPECT_EQ(against_film.advice[0].kind, AdviceKind::None) << against_film.advice[0].text;
  EXPECT_GT(against_film.score.percent, 97);
  const Analysis against_left_hander =
      analyze(student, {"a left-hander's film", mirrored(coach.motion)}).value().analysis;
  EXPECT_NEAR(against_left_hander.score.percent, against_film.score.percent, 1e-6);
  // The errors are there.
  const Analysis against_truth =
      analyze(student, {"coach", resample(*bundled_motion("swing"), 30)}).value().analysis;
  EXPECT_GT(against_truth.score.mean_joint_error_m, 3 * against_film.score.mean_joint_error_m);
}

TEST(Analyze, judges_only_the_timing_of_a_coach_who_was_filmed_from_another_side) {
  const StudentInput student = filmed_student(film(test_landmark_body(0.9), {0, 1.1, 4}, 45, {}).track),
                     coach = filmed_student(film(test_landmark_body(1.1), {-4, 1.1, 0.2}, 45, {}).track);
  ASSERT_EQ(coach.view, Viewpoint::DownTheLine);
  const Analysis analysis = analyze(student, {"coach's film", coach.motion}).value().analysis;
  EXPECT_TRUE(analysis.spatial.empty());
  EXPECT_NE(std::find(analysis.notes.begin(), analysis.notes.end(), text::coach_seen_elsewhere()),
            analysis.notes.end());
}

TEST(Analyze, tells_whose_joints_are_missing) {
  const Skeleton point = Skeleton::make({{"pelvis", kNoJoint, {}, HumanoidJoint::Pelvis}}).value();
  const Motion still = Motion::from_positions(point, {MediaTime{}}, {{}}).value();
  const Result<AnalyzedPair> pair =
      analyze(student_from_motion("me.bvh", swing_on({}, 30)), {"point.bvh", still});
  ASSERT_FALSE(pair);
  EXPECT_EQ(pair.error().code, ErrorCode::Incomplete);
  EXPECT_NE(pair.error().message.find("point.bvh"), std::string::npos) << pair.error().message;
}

}  // namespace
}  // namespace posecoach
