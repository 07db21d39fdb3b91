// What one analysis says beyond its first advice: parts of the score, poses and when they come, strictness,
// and blocks of swings.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/coaching/analysis_json.h"
#include "core/coaching/block.h"
#include "core/coaching/compare.h"
#include "core/coaching/strictness.h"
#include "core/motion/authored/golf_fault.h"
#include "tests/core/coaching/strokes.h"

namespace posecoach {
namespace {

GolfScript script_with(std::string_view fault, double amount) {
  const FaultChoice choice = choose_fault(fault, amount).value();
  GolfScript script = bundled_script(choice.fault->motion).value();
  EXPECT_TRUE(apply_fault(script, choice));
  return script;
}

Analysis analyzed(std::string_view fault, double amount, const CompareOptions& options = {},
                  double frames_per_second = 120) {
  const GolfScript script = script_with(fault, amount);
  StrokeShape shape{script.name(), 120, {.height_m = 1.80}, Handedness::Right};
  const Motion coach = make_stroke(shape).motion;
  shape.frames_per_second = frames_per_second;
  const Result<Analysis> analysis = compare(make_stroke(script, shape).motion, coach, options);
  EXPECT_TRUE(analysis) << (analysis ? "" : analysis.error().message);
  return *analysis;
}

const PartScore& part(const std::vector<PartScore>& parts, std::string_view name) {
  const auto found =
      std::find_if(parts.begin(), parts.end(), [&](const PartScore& p) { return p.name == name; });
  EXPECT_NE(found, parts.end()) << name;
  return *found;
}

TEST(PartScores, the_arm_that_is_bent_scores_lowest_and_the_downswing_without_a_fault_highest) {
  const Analysis analysis = analyzed("bent_lead_arm", 45);
  const double lead_arm = part(analysis.score.groups, "lead_arm").percent;
  for (const PartScore& group : analysis.score.groups) {
    if (group.name != "lead_arm" && group.name != "trail_arm") {
      EXPECT_GT(group.percent, lead_arm) << group.name;
    }
  }
  EXPECT_GT(part(analysis.score.phases, "follow_through").percent,
            part(analysis.score.phases, "backswing").percent);
}

TEST(PartScores, phases_weigh_up_to_the_whole) {
  const Analysis analysis = analyzed("sway", 10);
  double least = 100, most = 0;
  for (const PartScore& phase : analysis.score.phases) {
    least = std::min(least, phase.percent);
    most = std::max(most, phase.percent);
  }
  EXPECT_LE(least, analysis.score.percent);
  EXPECT_GE(most, analysis.score.percent);
}

TEST(PartScores, are_all_full_for_identical_motions) {
  const Motion swing = make_stroke().motion;
  const Analysis analysis = compare(swing, swing).value();
  EXPECT_EQ(analysis.score.groups.size(), 7U);
  for (const auto* parts : {&analysis.score.groups, &analysis.score.phases})
    for (const PartScore& one : *parts) EXPECT_EQ(one.percent, 100) << one.name;
}

TEST(PoseMatches, of_a_slow_backswing_come_late_from_the_top_on) {
  const Analysis analysis = analyzed("slow_backswing", 40);
  ASSERT_EQ(analysis.poses.size(), analysis.coach_events.size());
  for (const PoseMatch& match : analysis.poses) {
    EXPECT_NEAR(match.late_s, match.student_s - match.coach_s, 1e-12);
    if (match.event == "top" || match.event == "impact") {
      EXPECT_NEAR(match.late_s, 0.4 * 0.795, 0.05) << match.event;
      EXPECT_NE(match.advice.find("late"), std::string::npos) << match.advice;
    }
  }
  for (std::size_t k = 1; k < analysis.poses.size(); ++k)
    EXPECT_LE(analysis.poses[k - 1].student_frame, analysis.poses[k].student_frame);
}

TEST(PoseMatches, mark_the_joints_that_are_apart_and_how_far) {
  const Analysis analysis = analyzed("head_lift", 12);
  const auto impact = std::find_if(analysis.poses.begin(), analysis.poses.end(),
                                   [](const PoseMatch& match) { return match.event == "impact"; });
  ASSERT_NE(impact, analysis.poses.end());
  ASSERT_FALSE(impact->joints.empty());
  EXPECT_EQ(impact->joints.front().joint, "head");
  EXPECT_NEAR(impact->joints.front().offset_m.y, 0.12, 0.03);
  EXPECT_NEAR(impact->joints.front().distance_m, 0.12, 0.04);
  for (const PoseMatch& match : analysis.poses) {
    EXPECT_LE(match.joints.size(), 3U);
    for (std::size_t k = 1; k < match.joints.size(); ++k)
      EXPECT_GE(match.joints[k - 1].distance_m, match.joints[k].distance_m);
  }
  EXPECT_TRUE(analyzed("head_lift", 0).poses.front().joints.empty());
}

TEST(PoseMatches, of_the_same_motion_come_in_time) {
  const Analysis analysis = analyzed("sway", 0, {}, 60);
  for (const PoseMatch& match : analysis.poses) {
    EXPECT_LT(std::abs(match.late_s), 0.03) << match.event;
    EXPECT_NE(match.advice.find("in time"), std::string::npos) << match.advice;
  }
}

TEST(StrictnessOptions, zero_silences_a_part_and_two_tells_half_the_difference) {
  const auto first = [](const Analysis& analysis) { return analysis.advice.front(); };
  EXPECT_EQ(first(analyzed("sway", 10)).fault, "sway");
  EXPECT_NE(first(analyzed("sway", 10, {.strictness = Strictness::parse("hips=0").value()})).fault, "sway");
  EXPECT_EQ(first(analyzed("sway", 2.5)).kind, AdviceKind::None);
  const Analysis strict = analyzed("sway", 2.5, {.strictness = Strictness::parse("hips=2").value()});
  EXPECT_EQ(first(strict).fault, "sway");
  EXPECT_TRUE(std::any_of(strict.notes.begin(), strict.notes.end(), [](const std::string& note) {
    return note.find("harder") != std::string::npos && note.find("hips") != std::string::npos;
  }));
}

TEST(StrictnessOptions, never_move_the_score) {
  const Analysis usual = analyzed("sway", 10);
  const Analysis strict = analyzed("sway", 10, {.strictness = Strictness::parse("all=3").value()});
  EXPECT_EQ(strict.score.percent, usual.score.percent);
  EXPECT_EQ(strict.score.raw, usual.score.raw);
}

TEST(StrictnessOptions, of_timing_silence_the_timing) {
  EXPECT_EQ(analyzed("slow_backswing", 40).advice.front().fault, "slow_backswing");
  EXPECT_EQ(analyzed("slow_backswing", 40, {.strictness = Strictness::parse("timing=0").value()})
                .advice.front()
                .kind,
            AdviceKind::None);
}

TEST(StrictnessOptions, are_read_from_text_or_refused_with_what_they_may_be) {
  const Strictness both = Strictness::parse("arms=2,legs=0").value();
  EXPECT_EQ(both.of(JudgedPart::Arms), 2);
  EXPECT_EQ(both.of(JudgedPart::Legs), 0);
  EXPECT_EQ(both.of(JudgedPart::Head), 1);
  EXPECT_TRUE(Strictness::parse("").value().words().empty());
  for (const char* wrong : {"arm=2", "arms", "arms=", "arms=x", "arms=-1", "arms=11", "arms=2;legs=1", ","}) {
    const auto none = Strictness::parse(wrong);
    ASSERT_FALSE(none) << wrong;
    EXPECT_EQ(none.error().code, ErrorCode::InvalidArgument);
    EXPECT_NE(none.error().message.find("arms=2"), std::string::npos);
  }
}

TEST(Spread, is_mean_and_standard_deviation) {
  const Spread spread = spread_of(std::vector<double>{70, 74, 78, 82});
  EXPECT_EQ(spread.count, 4);
  EXPECT_NEAR(spread.mean, 76, 1e-12);
  EXPECT_NEAR(spread.deviation, std::sqrt(80.0 / 3), 1e-12);
  EXPECT_EQ(spread_of(std::vector<double>{3}).deviation, 0);
  EXPECT_EQ(spread_of({}).count, 0);
}

TEST(Block, tells_the_spread_of_the_score_and_of_the_tempo_and_what_comes_again) {
  const std::vector<Analysis> swings = {analyzed("sway", 9), analyzed("sway", 12), analyzed("sway", 0),
                                        analyzed("sway", 15)};
  std::vector<BlockSwing> block_swings;
  for (const Analysis& swing : swings) block_swings.push_back(block_swing_from(swing));
  const Block block = make_block(block_swings);
  EXPECT_EQ(block.swings, 4);
  EXPECT_GT(block.percent.deviation, 1);
  ASSERT_FALSE(block.advice.empty());
  EXPECT_EQ(block.advice.front().fault, "sway");
  EXPECT_EQ(block.advice.front().swings, 3);
  EXPECT_EQ(block.advice.front().clearest_swing, 3);
  EXPECT_NE(block.words.find("In 3 of them"), std::string::npos) << block.words;
  const auto tempo = std::find_if(block.metrics.begin(), block.metrics.end(),
                                  [](const MetricSpread& m) { return m.name == "tempo_ratio"; });
  ASSERT_NE(tempo, block.metrics.end());
  EXPECT_EQ(tempo->spread.count, 4);
  EXPECT_LT(tempo->spread.deviation, 0.05);
}

TEST(Block, of_putts_tells_how_even_their_time_is) {
  std::vector<Analysis> putts;
  for (const double slower : {0.0, 20.0, 40.0}) putts.push_back(analyzed("uneven_tempo", slower));
  // As the library keeps them.
  std::vector<BlockSwing> swings;
  for (const Analysis& putt : putts) swings.push_back(block_swing_from_json(to_json(putt)).value());
  const Block block = make_block(swings);
  const auto total = std::find_if(block.metrics.begin(), block.metrics.end(),
                                  [](const MetricSpread& m) { return m.name == "total_time_s"; });
  ASSERT_NE(total, block.metrics.end());
  EXPECT_NEAR(total->spread.deviation, 0.2 * 0.32, 0.01);
}

TEST(Block, from_stored_analyses_is_the_same_as_from_the_analyses_themselves) {
  std::vector<BlockSwing> fresh, stored;
  for (const double sway : {6.0, 12.0}) {
    const Analysis analysis = analyzed("sway", sway);
    fresh.push_back(block_swing_from(analysis));
    stored.push_back(block_swing_from_json(to_json(analysis)).value());
  }
  EXPECT_EQ(to_json(make_block(stored)), to_json(make_block(fresh)));
}

TEST(Block, a_text_that_is_no_analysis_is_refused) {
  for (const char* text : {"", "[]", "{\"score\": {}}", "{\"score\": {\"percent\": \"high\"}}"})
    EXPECT_EQ(block_swing_from_json(text).error().code, ErrorCode::Malformed) << text;
}

TEST(Block, of_nothing_is_empty) {
  EXPECT_EQ(make_block({}).swings, 0);
}

}  // namespace
}  // namespace posecoach
