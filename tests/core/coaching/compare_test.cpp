#include "core/coaching/compare.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/coaching/analysis_json.h"
#include "tests/core/coaching/strokes.h"

namespace posecoach {
namespace {

Analysis analyzed(const Motion& student, const Motion& coach, const CompareOptions& options = {}) {
  const Result<Analysis> analysis = compare(student, coach, options);
  EXPECT_TRUE(analysis.has_value()) << (analysis ? "" : analysis.error().message);
  return analysis.value();
}

// Bends the arm that ends in `wrist` outwards at `at_s`, for a short time.
Motion with_lead_elbow_moved(const Motion& motion, double at_s, double metres) {
  const int elbow = motion.skeleton().find(HumanoidJoint::LeftElbow);
  return with_positions(motion, [&, elbow](int frame, int joint, const Vec3& p) {
    const double d = (to_seconds(motion.time(frame)) - at_s) / 0.15;
    return joint == elbow ? p + Vec3(0, metres * std::exp(-d * d), 0) : p;
  });
}

TEST(Compare, identical_motions_have_no_error_full_score_and_no_advice) {
  for (const char* name : {"swing", "putt"}) {
    const Motion motion = make_stroke({.name = name}).motion;
    const Analysis analysis = analyzed(motion, motion);
    EXPECT_EQ(analysis.score.raw, 0);
    EXPECT_EQ(analysis.score.percent, 100);
    ASSERT_EQ(analysis.advice.size(), 1U);
    EXPECT_EQ(analysis.advice[0].kind, AdviceKind::None);
    for (const auto& [student, coach] : analysis.path) EXPECT_EQ(student, coach);
  }
}

TEST(Compare, the_same_input_gives_the_same_bits) {
  const Motion coach = make_stroke().motion, student = trembling(coach, 0.01, 0.8);
  EXPECT_EQ(to_json(analyzed(student, coach)), to_json(analyzed(student, coach)));
}

TEST(Compare, the_same_motion_at_another_speed_scores_about_100) {
  const Motion coach = make_stroke().motion;
  for (const double factor : {0.7, 1.3, 2.0})
    EXPECT_GE(analyzed(slowed_by(coach, factor), coach).score.percent, 99) << factor;
}

TEST(Compare, path_covers_every_student_frame_of_the_swing_without_gaps) {
  for (const double student_fps : {30.0, 100.0, 240.0}) {
    const Motion student = make_stroke({.frames_per_second = student_fps}).motion;
    const Analysis analysis = analyzed(student, make_stroke().motion);
    EXPECT_EQ(analysis.path.front().first, analysis.student_events.front().frame);
    EXPECT_EQ(analysis.path.back().first, analysis.student_events.back().frame);
    EXPECT_EQ(analysis.path.size(), analysis.path_error_m.size());
    for (std::size_t k = 1; k < analysis.path.size(); ++k) {
      const int i = analysis.path[k].first - analysis.path[k - 1].first;
      const int j = analysis.path[k].second - analysis.path[k - 1].second;
      EXPECT_TRUE((i == 0 || i == 1) && (j == 0 || j == 1) && i + j > 0) << k;
    }
  }
}

TEST(Compare, raw_is_the_summed_joint_error_along_the_path) {
  const Motion coach = make_stroke().motion;
  const Analysis analysis = analyzed(with_lead_elbow_moved(coach, 1.5, 0.1), coach);
  double sum = 0;
  for (const double error : analysis.path_error_m) sum += error * analysis.score.joints_compared;
  EXPECT_NEAR(analysis.score.raw, sum, 1e-9);
  EXPECT_NEAR(analysis.score.mean_joint_error_m * analysis.score.joints_compared *
                  static_cast<double>(analysis.path.size()),
              sum, 1e-9);
}

TEST(Compare, a_larger_displacement_scores_lower) {
  const Motion coach = make_stroke().motion;
  double last_percent = 100, last_raw = 0;
  for (const double metres : {0.03, 0.06, 0.1, 0.15, 0.2}) {
    const Analysis analysis = analyzed(with_lead_elbow_moved(coach, 1.5, metres), coach);
    EXPECT_LT(analysis.score.percent, last_percent) << metres;
    EXPECT_GT(analysis.score.raw, last_raw) << metres;
    last_percent = analysis.score.percent;
    last_raw = analysis.score.raw;
  }
}

TEST(Compare, an_elbow_in_the_wrong_place_is_named_with_joint_event_and_frame) {
  const AuthoredMotion stroke = make_stroke();
  const Analysis analysis =
      analyzed(with_lead_elbow_moved(stroke.motion, stroke.time_of("top"), 0.12), stroke.motion);
  ASSERT_FALSE(analysis.spatial.empty());
  EXPECT_EQ(analysis.spatial[0].joint, "left_elbow");
  EXPECT_EQ(analysis.spatial[0].event, "top");
  EXPECT_NEAR(analysis.spatial[0].student_frame, stroke.time_of("top") * 120, 4);
  EXPECT_EQ(analysis.advice[0].kind, AdviceKind::Spatial);
  EXPECT_NE(analysis.advice[0].text.find("At the top, your lead"), std::string::npos)
      << analysis.advice[0].text;
}

TEST(Compare, a_downswing_half_as_quick_again_is_named_with_its_ratio) {
  for (const double fps : {30.0, 120.0}) {
    GolfScript script = bundled_script("swing").value();
    script.stretch("top", "impact", 1 / 1.5);
    const Analysis analysis =
        analyzed(make_stroke(script, {.frames_per_second = fps}).motion, make_stroke().motion);
    ASSERT_EQ(analysis.advice[0].kind, AdviceKind::Timing) << analysis.advice[0].text;
    EXPECT_NE(analysis.advice[0].text.find("downswing"), std::string::npos) << analysis.advice[0].text;
    const auto downswing =
        std::find_if(analysis.timing.begin(), analysis.timing.end(),
                     [](const TimingAdvice& t) { return t.from == "top" && t.to == "impact"; });
    ASSERT_NE(downswing, analysis.timing.end());
    EXPECT_NEAR(downswing->ratio, 1 / 1.5, 0.1 / 1.5) << fps;
  }
}

TEST(Compare, a_slow_backswing_is_named) {
  GolfScript script = bundled_script("swing").value();
  script.stretch("takeaway", "top", 1.4);
  const Analysis analysis = analyzed(make_stroke(script, {}).motion, make_stroke().motion);
  EXPECT_EQ(analysis.advice[0].kind, AdviceKind::Timing);
  EXPECT_NE(analysis.advice[0].text.find("backswing"), std::string::npos) << analysis.advice[0].text;
}

TEST(Compare, a_film_in_slow_motion_is_judged_in_proportion) {
  const Motion coach = make_stroke().motion;
  const Analysis analysis = analyzed(slowed_by(coach, 3), coach);
  EXPECT_EQ(analysis.advice[0].kind, AdviceKind::None) << analysis.advice[0].text;
  EXPECT_FALSE(analysis.notes.empty());
}

TEST(Compare, hips_that_sway_are_named_at_the_top_and_not_told_again_as_head_and_arms) {
  GolfScript script = bundled_script("swing").value();
  const std::vector<GolfScript::Offset> sway = {{"address", 0}, {"top", -10}, {"impact", 0}};
  script.add(GolfChannel::PelvisSway, sway);
  const Analysis analysis = analyzed(make_stroke(script).motion, make_stroke().motion);
  ASSERT_EQ(analysis.spatial.size(), 1U);
  EXPECT_EQ(analysis.spatial[0].joint, "pelvis");
  EXPECT_EQ(analysis.spatial[0].event, "top");
  EXPECT_NEAR(analysis.spatial[0].offset_m.x, -0.1, 0.015);
  EXPECT_NE(analysis.advice[0].text.find("from the target"), std::string::npos) << analysis.advice[0].text;
}

TEST(Compare, from_30_and_from_120_frames_a_second_comes_the_same_advice) {
  GolfScript script = bundled_script("swing").value();
  const std::vector<GolfScript::Offset> bend = {{"address", 0}, {"top", 35}, {"impact", 0}};
  script.add(GolfChannel::LeadElbow, bend);
  const Motion coach = make_stroke().motion;
  const Analysis slow = analyzed(make_stroke(script, {.frames_per_second = 30}).motion, coach);
  const Analysis fast = analyzed(make_stroke(script, {.frames_per_second = 120}).motion, coach);
  ASSERT_EQ(slow.advice.size(), fast.advice.size());
  for (std::size_t k = 0; k < slow.advice.size(); ++k) EXPECT_EQ(slow.advice[k].text, fast.advice[k].text);
  EXPECT_NEAR(slow.score.percent, fast.score.percent, 0.5);
}

TEST(Compare, a_faultless_swing_gets_no_advice_at_any_frame_rate_or_camera_angle) {
  const Motion coach = make_stroke().motion;
  for (const double fps : {25.0, 30.0, 60.0, 240.0})
    for (const double yaw : {0.0, 0.6, 3.0}) {
      const Analysis analysis =
          analyzed(turned_by(make_stroke({.frames_per_second = fps}).motion, yaw), coach);
      EXPECT_EQ(analysis.advice[0].kind, AdviceKind::None) << fps << " fps: " << analysis.advice[0].text;
      EXPECT_GT(analysis.score.percent, 99.5);
    }
}

TEST(Compare, the_cameras_yaw_changes_nothing) {
  const Motion coach = make_stroke().motion;
  const Motion student = with_lead_elbow_moved(coach, 1.5, 0.1);
  const Analysis straight = analyzed(student, coach);
  for (const double yaw : {0.35, -1.2, 3.1}) {
    const Analysis turned = analyzed(turned_by(student, yaw), coach);
    EXPECT_NEAR(turned.score.percent, straight.score.percent, 0.05);
    EXPECT_NEAR(std::remainder(turned.coach_yaw - straight.coach_yaw - yaw, 2 * kPi), 0, 2e-3);
    EXPECT_EQ(turned.advice[0].text, straight.advice[0].text);
  }
}

TEST(Compare, a_left_handed_swing_gives_identical_numbers_and_mirrored_joints) {
  const AuthoredMotion stroke = make_stroke();
  const Motion student = with_lead_elbow_moved(stroke.motion, stroke.time_of("top"), 0.12);
  const Analysis right = analyzed(student, stroke.motion);
  const Motion student_mirrored = mirrored(student), coach_mirrored = mirrored(stroke.motion);
  for (const Motion& coach : {stroke.motion, coach_mirrored}) {
    const Analysis left = analyzed(student_mirrored, coach);
    EXPECT_EQ(left.student.hand, Handedness::Left);
    EXPECT_EQ(left.score.raw, right.score.raw);
    EXPECT_EQ(left.score.percent, right.score.percent);
    EXPECT_EQ(left.path, right.path);
    ASSERT_EQ(left.metrics.size(), right.metrics.size());
    for (std::size_t k = 0; k < left.metrics.size(); ++k)
      EXPECT_EQ(left.metrics[k].value, right.metrics[k].value);
    ASSERT_EQ(left.advice.size(), right.advice.size());
    for (std::size_t k = 0; k < left.advice.size(); ++k) EXPECT_EQ(left.advice[k].text, right.advice[k].text);
    ASSERT_FALSE(left.spatial.empty());
    EXPECT_EQ(left.spatial[0].joint, "right_elbow");
    EXPECT_NEAR(left.spatial[0].offset_m.x, -right.spatial[0].offset_m.x, 1e-12);
  }
}

TEST(Compare, doubt_widens_the_score_and_never_moves_it) {
  const Motion coach = make_stroke().motion;
  const Motion student = with_lead_elbow_moved(coach, 1.5, 0.1);
  const std::size_t count = static_cast<std::size_t>(student.frame_count() * student.joint_count());
  const auto same = [](int, int, const Vec3& p) { return p; };
  const Analysis sure = analyzed(student, coach);
  const Analysis unsure = analyzed(with_positions(student, same, std::vector<double>(count, 0.5)), coach);
  EXPECT_NEAR(unsure.score.percent, sure.score.percent, 0.1);
  EXPECT_NEAR(unsure.score.raw, sure.score.raw, 0.01 * sure.score.raw);
  EXPECT_EQ(sure.score.plus_minus, 0);
  EXPECT_GT(unsure.score.plus_minus, 1);
}

TEST(Compare, tempo_counts_from_takeaway_and_carries_its_uncertainty) {
  const auto metric = [](const Analysis& analysis, const char* name) {
    return *std::find_if(analysis.metrics.begin(), analysis.metrics.end(),
                         [&](const Metric& m) { return m.name == name; });
  };
  const Motion coach = make_stroke().motion;
  const Metric fine = metric(analyzed(coach, coach), "tempo_ratio");
  EXPECT_NEAR(fine.value, 3.0, 0.2);
  EXPECT_TRUE(fine.available);
  const Metric coarse = metric(analyzed(make_stroke({.frames_per_second = 30}).motion, coach), "tempo_ratio");
  EXPECT_GT(coarse.plus_minus, fine.plus_minus);
  EXPECT_NEAR(metric(analyzed(make_stroke({.name = "putt"}).motion, make_stroke({.name = "putt"}).motion),
                     "tempo_ratio")
                  .value,
              2.0, 0.2);
}

TEST(Compare, one_camera_greys_what_it_cannot_see_with_the_reason) {
  const Motion coach = make_stroke().motion;
  const auto find = [](const Analysis& analysis, const char* name) {
    return *std::find_if(analysis.metrics.begin(), analysis.metrics.end(),
                         [&](const Metric& m) { return m.name == name; });
  };
  const Analysis face_on = analyzed(coach, coach, {.views = {Viewpoint::FaceOn}});
  EXPECT_FALSE(find(face_on, "thrust_impact_cm").available);
  EXPECT_NE(find(face_on, "thrust_impact_cm").reason.find("face-on"), std::string::npos);
  EXPECT_TRUE(find(face_on, "sway_top_cm").available);
  const Analysis down_the_line = analyzed(coach, coach, {.views = {Viewpoint::DownTheLine}});
  EXPECT_FALSE(find(down_the_line, "sway_top_cm").available);
  EXPECT_TRUE(find(down_the_line, "thrust_impact_cm").available);
}

TEST(Compare, a_putt_is_not_compared_with_a_full_swing) {
  const Result<Analysis> analysis = compare(make_stroke({.name = "putt"}).motion, make_stroke().motion);
  ASSERT_FALSE(analysis);
  EXPECT_NE(analysis.error().message.find("putt"), std::string::npos);
}

TEST(Compare, a_student_without_a_takeaway_is_scored_and_told_why_there_are_no_events) {
  const AuthoredMotion stroke = make_stroke();
  const int start = static_cast<int>(stroke.time_of("toe_up") * 120);
  const Analysis analysis = analyzed(stroke.motion.slice(start, stroke.motion.frame_count()), stroke.motion);
  EXPECT_TRUE(analysis.student_events.empty());
  EXPECT_FALSE(analysis.notes.empty());
  EXPECT_GT(analysis.score.percent, 50);
}

}  // namespace
}  // namespace posecoach
