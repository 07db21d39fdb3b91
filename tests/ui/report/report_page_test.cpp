#include "ui/report/report_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/support/compared_motions.h"
#include "ui/report/html.h"
#include "ui/report/replay.h"

namespace posecoach {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string page_of(const ComparedMotions& motions, std::span<const ReportPicture> pictures = {}) {
  return make_report_page({motions.analysis, motions.student, 0, motions.coach}, pictures);
}

TEST(ReportPage, says_score_and_all_advice) {
  const ComparedMotions motions = make_compared_motions();
  const std::string page = page_of(motions);
  for (const Advice& advice : motions.analysis.advice) EXPECT_THAT(page, HasSubstr(advice.text));
  for (const TimingAdvice& timing : motions.analysis.timing) EXPECT_THAT(page, HasSubstr(timing.advice));
  for (const SpatialAdvice& spatial : motions.analysis.spatial) EXPECT_THAT(page, HasSubstr(spatial.advice));
  for (const std::string& note : motions.analysis.notes) EXPECT_THAT(page, HasSubstr(note));
  for (const char* words : {">81<", "lower is better", "12.50", "Left wrist", "Tempo ratio",
                            "not visible from down the line", "my swing.mp4", "rotation"})
    EXPECT_THAT(page, HasSubstr(words));
}

TEST(ReportPage, shows_the_score_of_every_part) {
  ComparedMotions motions = make_compared_motions();
  motions.analysis.score.groups = {{"lead_arm", 0.081, 51.2}, {"hips", 0.01, 97.4}};
  motions.analysis.score.phases = {{"follow_through", 0.05, 73.3}};
  const std::string page = page_of(motions);
  for (const char* words : {"Lead arm", ">51 <", "8.1&nbsp;cm", ">97 <", "Follow-through", ">73 <",
                            "class=\"poor\"", "class=\"fair\"", "class=\"good\""})
    EXPECT_THAT(page, HasSubstr(words));
  EXPECT_THAT(page_of(make_compared_motions()), Not(HasSubstr("id=\"parts\"")));
}

TEST(ReportPage, draws_every_pair_of_poses_with_its_joints_marked) {
  ComparedMotions motions = make_compared_motions();
  PoseMatch top;
  top.event = "top";
  top.student_frame = top.coach_frame = motions.analysis.student_events[1].frame;
  top.advice = "At the top, you are 0.12 s late.";
  top.joints = {{"left_wrist", Vec3(0.1, 0.1, 0), 0.14}, {"head", Vec3(0, 0.06, 0), 0.06}};
  motions.analysis.poses = {top};
  const std::string page = page_of(motions);
  for (const char* words : {"id=\"poses\"", top.advice.c_str(),
                            "Left wrist&nbsp;14&nbsp;cm, Head&nbsp;6&nbsp;cm", "seen from the front"})
    EXPECT_THAT(page, HasSubstr(words));
  const std::size_t marks = page.find("class=\"marks\"");
  ASSERT_NE(marks, std::string::npos);
  // Two rings and a line a joint.
  const std::string drawn = page.substr(marks, page.find("</svg>", marks) - marks);
  EXPECT_EQ(std::count(drawn.begin(), drawn.end(), '<'), 2 * 3 + 1);
}

TEST(ReportPage, tells_of_the_last_swings_where_there_are_several) {
  const ComparedMotions motions = make_compared_motions();
  Block block;
  block.swings = 4;
  block.percent = {4, 72.2, 5.4};
  block.metrics = {{"tempo_ratio", "Tempo", "", {4, 3.01, 0.25}, 3.0}};
  block.advice = {{"sway", "hips_to_target", "top", 3, "Your hips <sway>.", 1}};
  const Comparison comparison{motions.analysis, motions.student, 0, motions.coach};
  const std::string page = make_report_page(comparison, {}, block);
  for (const char* words :
       {"Your last 4 swings", "<b>72</b> ±&nbsp;5", "3 of 4", "&lt;sway&gt;", "Tempo", "3.0"})
    EXPECT_THAT(page, HasSubstr(words));
  block.swings = 1;
  EXPECT_THAT(make_report_page(comparison, {}, block), Not(HasSubstr("Your last")));
}

TEST(ReportPage, needs_nothing_from_outside) {
  const ComparedMotions motions = make_compared_motions();
  const ReportPicture picture{30, 30, Image::black(30, 40), "Top: left elbow 10 cm away"};
  const std::string page = page_of(motions, std::span(&picture, 1));
  for (const char* reference : {"http", "//cdn", "@import", "url(", "src=\"/", "href="})
    EXPECT_THAT(page, Not(HasSubstr(reference)));
  EXPECT_THAT(page, HasSubstr("src=\"data:image/jpeg;base64,"));
  EXPECT_THAT(page, HasSubstr(picture.caption));
}

TEST(ReportPage, text_from_files_cannot_become_markup) {
  ComparedMotions motions = make_compared_motions();
  const std::string evil = "</script><script>alert(\"x\")</script>'&\xff";
  Analysis& analysis = motions.analysis;
  analysis.student.source = analysis.coach.source = analysis.retarget_method = evil;
  analysis.advice[0].text = analysis.timing[0].advice = analysis.spatial[0].advice = analysis.notes[0] = evil;
  analysis.joint_errors[0].joint = analysis.metrics[0].name = analysis.metrics[0].unit = evil;
  analysis.metrics[1].title = analysis.metrics[1].reason = analysis.student_events[1].name =
      analysis.timing[0].from = evil;
  analysis.spatial[0].joint = analysis.spatial[0].event = evil;
  const ReportPicture picture{30, 30, Image::black(8, 8), evil};
  const std::string page = page_of(motions, std::span(&picture, 1));
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(page, Not(HasSubstr("alert(\"x\")")));
  EXPECT_THAT(page, Not(HasSubstr("\xff")));
  EXPECT_THAT(page, HasSubstr("&lt;/script&gt;"));
}

TEST(ReportPage, empty_analysis_makes_a_page) {
  ComparedMotions motions = make_compared_motions();
  motions.analysis = Analysis{};
  const std::string page = page_of(motions);
  EXPECT_THAT(page, HasSubstr("</html>"));
  EXPECT_THAT(page, Not(HasSubstr("nan")));
  EXPECT_THAT(page, Not(HasSubstr("id=\"timing\"")));
  EXPECT_THAT(page, Not(HasSubstr("id=\"pictures\"")));
}

TEST(ReportPage, no_difference_found_has_no_moment_to_show) {
  ComparedMotions motions = make_compared_motions();
  motions.analysis.advice = {{AdviceKind::None, "No clear difference from the coach was found.", 0, 0, 0}};
  motions.analysis.spatial.clear();
  const std::string page = page_of(motions);
  EXPECT_THAT(page, HasSubstr("No clear difference"));
  EXPECT_THAT(page.substr(0, page.find("</section>")), Not(HasSubstr("class=\"moment\"")));
}

TEST(ReportPage, very_long_motion_keeps_the_page_small) {
  ComparedMotions motions = make_compared_motions(6000);
  for (int i = 0; i < 200; ++i) motions.analysis.joint_errors.push_back({"head", 0.1, 0.2});
  const std::string page = page_of(motions);
  EXPECT_LT(page.size(), 900'000U);
  EXPECT_THAT(page, HasSubstr("5999"));
}

TEST(ReportPage, numbers_out_of_hand_are_no_harm) {
  ComparedMotions motions = make_compared_motions();
  motions.analysis.metrics[0].value = std::numeric_limits<double>::infinity();
  motions.analysis.metrics[0].coach = std::numeric_limits<double>::quiet_NaN();
  motions.analysis.metrics[1].available = true;
  motions.analysis.metrics[1].value = 1e12;
  motions.analysis.timing[0].ratio = std::numeric_limits<double>::quiet_NaN();
  motions.analysis.score.percent = 0;
  motions.analysis.path.emplace_back(999, 999);  // beyond both motions
  const std::string page = page_of(motions);
  EXPECT_THAT(page, Not(HasSubstr("nan")));
  EXPECT_THAT(page, Not(HasSubstr(">inf")));
}

TEST(ReportPage, the_same_analysis_gives_the_same_page) {
  EXPECT_EQ(page_of(make_compared_motions()), page_of(make_compared_motions()));
}

TEST(Replay, steps_are_pairs_of_the_path_in_time) {
  const ComparedMotions motions = make_compared_motions(500);
  const Replay replay = make_replay({motions.analysis, motions.student, 0, motions.coach}, 100);
  EXPECT_GE(replay.steps.size(), 100U);
  EXPECT_LE(replay.steps.size(), 115U);
  EXPECT_EQ(replay.steps.front().student_frame, 0);
  EXPECT_EQ(replay.steps.back().student_frame, 499);
  for (std::size_t i = 1; i < replay.steps.size(); ++i) {
    EXPECT_GT(replay.steps[i].student_s, replay.steps[i - 1].student_s);
    EXPECT_EQ(replay.steps[i].student_frame, replay.steps[i].coach_frame);
    EXPECT_NEAR(replay.steps[i].speed, 1, 1e-6);
  }
}

TEST(Replay, the_pairs_that_advice_speaks_of_are_kept) {
  ComparedMotions motions = make_compared_motions(3000);
  motions.analysis.path.clear();
  for (int i = 0; i < 3000; ++i)  // two coach frames for each of the student's
    for (int k = 0; k < 2 && i < 1500; ++k) motions.analysis.path.emplace_back(i, 2 * i + k);
  motions.analysis.advice[0].student_frame = 777;
  motions.analysis.advice[0].coach_frame = 1555;
  const Replay replay = make_replay({motions.analysis, motions.student, 0, motions.coach}, 50);
  const ReplayStep& step = replay.steps[static_cast<std::size_t>(step_at(replay, 777, 1555))];
  EXPECT_EQ(step.student_frame, 777);
  EXPECT_EQ(step.coach_frame, 1555);
}

TEST(Replay, film_frames_before_the_motion_are_counted) {
  ComparedMotions motions = make_compared_motions();
  for (auto& [student, coach] : motions.analysis.path) student += 25;
  const Replay replay = make_replay({motions.analysis, motions.student, 25, motions.coach}, 500);
  ASSERT_EQ(replay.steps.size(), 60U);
  EXPECT_EQ(replay.steps.front().student_frame, 25);
  EXPECT_EQ(replay.steps.front().student_s, 0);
}

TEST(Replay, student_faces_the_viewer_at_the_beginning) {
  const ComparedMotions motions = make_compared_motions();
  const Replay replay = make_replay({motions.analysis, motions.student, 0, motions.coach}, 100);
  const auto joint = [&](HumanoidJoint role) {
    return static_cast<std::size_t>(std::find(replay.joints.begin(), replay.joints.end(), role) -
                                    replay.joints.begin());
  };
  const std::vector<Vec3>& first = replay.steps.front().student;
  EXPECT_GT(first[joint(HumanoidJoint::LeftHip)].x, first[joint(HumanoidJoint::RightHip)].x + 0.05);
  EXPECT_GT(first[joint(HumanoidJoint::LeftToe)].z, first[joint(HumanoidJoint::LeftAnkle)].z);
}

TEST(Html, base64_of_known_words) {
  EXPECT_EQ(html::base64(""), "");
  EXPECT_EQ(html::base64("f"), "Zg==");
  EXPECT_EQ(html::base64("fo"), "Zm8=");
  EXPECT_EQ(html::base64("foobar"), "Zm9vYmFy");
}

TEST(Html, script_strings_end_only_at_their_quotes) {
  EXPECT_EQ(html::script_string("a\"b\\c</x>\n"), "\"a\\u0022b\\u005cc\\u003c/x\\u003e\\u000a\"");
}

}  // namespace
}  // namespace posecoach
