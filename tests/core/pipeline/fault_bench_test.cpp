// Known faults through true joints, on bodies that are not the coach's: named first, by about their amount;
// and no fault found where there is none.
#include "core/pipeline/fault_bench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/pipeline/event_bench.h"
#include "tests/core/pipeline/filmed.h"
#include "tests/core/retarget/motions.h"

namespace posecoach {
namespace {

std::vector<BenchAnswer> answers_for(const BenchPlan& plan) {
  const auto cases = make_bench_cases(plan);
  EXPECT_TRUE(cases) << (cases ? "" : cases.error().message);
  const auto answers = run_fault_bench(*cases, see_true_joints, bundled_coach);
  EXPECT_TRUE(answers) << (answers ? "" : answers.error().message);
  return *answers;
}

std::string first_advice(const BenchAnswer& answer) {
  if (!answer.refusal.empty()) return answer.refusal;
  return answer.advice.empty() ? "no advice" : answer.advice.front().text;
}

// One part and a handful of bodies stand for the whole table, which `posecoach evaluate coaching` prints.
TEST(FaultBench, names_95_of_100_faults_first_on_any_body_and_hand) {
  const std::vector<BenchAnswer> answers =
      answers_for({.parts = {1}, .bodies = {"average", "short", "woman", "arms-20%", "legs+25%", "2.00m"}});
  int faults = 0, first = 0, right = 0;
  for (const BenchAnswer& answer : answers) {
    if (!answer.asked.fault) continue;
    ++faults;
    first += answer.rank == 1 ? 1 : 0;
    right += answer.is_amount_right() ? 1 : 0;
    if (answer.rank != 1) {
      std::printf("%s: %s\n", name_of(answer.asked).c_str(), first_advice(answer).c_str());
    }
  }
  EXPECT_GE(first, 0.95 * faults);
  EXPECT_GE(right, 0.9 * faults);
}

TEST(FaultBench, finds_nothing_in_faultless_strokes_of_any_body) {
  for (const BenchAnswer& answer : answers_for({.parts = {}}))
    EXPECT_TRUE(answer.refusal.empty() && answer.advice.empty())
        << name_of(answer.asked) << ": " << first_advice(answer);
}

TEST(FaultBench, scores_faultless_strokes_of_any_body_within_two_points) {
  for (const BenchAnswer& answer : answers_for({.parts = {}}))
    EXPECT_GE(answer.percent, 98) << name_of(answer.asked);
}

TEST(FaultBench, asks_every_fault_of_every_body_with_both_hands) {
  const auto cases = make_bench_cases({.parts = {1, 1.5}, .bodies = {"tall", "short"}}).value();
  std::set<std::string> names, faults;
  int left = 0;
  for (const BenchCase& one : cases) {
    EXPECT_TRUE(names.insert(name_of(one)).second) << name_of(one);
    if (one.fault) faults.emplace(one.fault->name);
    left += one.hand == Handedness::Left ? 1 : 0;
  }
  EXPECT_EQ(faults.size(), golf_faults().size());
  EXPECT_GT(left, static_cast<int>(cases.size()) / 3);
  EXPECT_FALSE(make_bench_cases({.bodies = {"nobody"}}));
}

TEST(FaultBench, tallies_what_was_answered) {
  const GolfFault* sway = choose_fault("sway").value().fault;
  BenchAnswer first{
      {"swing", sway, 10, {}, Handedness::Right, 30, BenchEye::TrueJoints}, {}, 80, {}, 1, 0.1, 0.1};
  BenchAnswer third = first, missed = first, refused = first, alarmed = first;
  third.rank = 3;
  third.amount_told = 0.2;
  missed.rank = 0;
  refused.rank = 0;
  refused.refusal = "nobody is seen";
  alarmed.asked.fault = nullptr;
  alarmed.advice = {{AdviceKind::Spatial, "Something.", 0, 0, 1, {}, {}, {}, 0}};
  const std::vector<BenchRow> rows = tally({first, third, missed, refused, alarmed});
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].cases, 4);
  EXPECT_EQ(rows[0].first, 1);
  EXPECT_EQ(rows[0].top_three, 2);
  EXPECT_EQ(rows[0].amount_right, 1);
  EXPECT_EQ(rows[0].refused, 1);
  EXPECT_EQ(rows[0].percent_mean, 80);
  EXPECT_EQ(rows[1].false_alarms, 1);
}

TEST(FaultBench, tallies_how_late_events_are) {
  BenchAnswer early{{"swing", nullptr, 0, {}, Handedness::Right, 30, BenchEye::FaceOn}, {}, 80, {}, 0, 0, 0};
  early.events_late = {{"takeaway", -0.02}, {"top", 0.0}};
  BenchAnswer late = early, putt = early, refused = early;
  late.events_late = {{"takeaway", 0.06}, {"top", 0.0}};
  putt.asked.motion = "putt";
  refused.events_late = {};
  const std::vector<BenchEventRow> rows = tally_events({putt, early, late, refused});
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0].motion, "swing");
  EXPECT_EQ(rows[0].event, "takeaway");
  EXPECT_EQ(rows[0].strokes, 2);
  EXPECT_EQ(rows[0].within, 1);
  EXPECT_NEAR(rows[0].late_s, 0.02, 1e-12);
  EXPECT_NEAR(rows[0].spread_s, 0.04, 1e-12);
  EXPECT_EQ(rows[1].within, 2);
  EXPECT_EQ(rows[3].motion, "putt");
}

// A camera and a pose stage whose errors are chance alone.
Result<StudentInput> see_through_camera(const BenchCase& one) {
  const auto stroke = make_stroke_of(one);
  if (!stroke) return tl::unexpected(stroke.error());
  const Vec3 eye = one.eye == BenchEye::FaceOn ? Vec3(0, 1.2, 3.6) : Vec3(-3.6, 1.2, 0.3);
  const Filmed filmed = film(stroke->motion, test_landmark_body(1), eye, 50, {1.0, 0.005, 0.01});
  const auto lifted = lift(filmed.track);
  if (!lifted) return tl::unexpected(lifted.error());
  return student_from_film(name_of(one), filmed.track, *lifted);
}

TEST(FaultBench, a_film_of_30_frames_a_second_is_told_what_one_of_120_is) {
  std::vector<BenchCase> cases;
  for (const char* name : {"sway", "slow_backswing", "early_extension"})
    for (const double rate : {30.0, 120.0}) {
      const GolfFault* fault = choose_fault(name).value().fault;
      const BenchEye eye =
          std::string_view(name) == "early_extension" ? BenchEye::DownTheLine : BenchEye::FaceOn;
      cases.push_back({"swing", fault, fault->default_amount, {}, Handedness::Right, rate, eye});
    }
  const auto answers = run_fault_bench(cases, see_through_camera, bundled_coach);
  ASSERT_TRUE(answers) << answers.error().message;
  for (std::size_t k = 0; k + 1 < answers->size(); k += 2) {
    const BenchAnswer& slow = (*answers)[k];
    const BenchAnswer& quick = (*answers)[k + 1];
    EXPECT_GT(slow.rank, 0) << name_of(slow.asked) << ": " << first_advice(slow);
    EXPECT_EQ(slow.rank, quick.rank) << name_of(quick.asked) << ": " << first_advice(quick);
    EXPECT_NEAR(slow.amount_told, quick.amount_told, 0.25 * std::abs(slow.amount_told))
        << name_of(slow.asked);
  }
  for (const BenchAgreement& row : agreement_of_frame_rates(*answers)) {
    EXPECT_EQ(row.same_first, row.pairs);
    EXPECT_EQ(row.scores_within, row.pairs);
    // A plus-minus is two standard deviations: one in twenty lies outside.
    EXPECT_GE(row.metrics_within, 0.9 * row.metrics);
    EXPECT_GT(row.metrics, 5 * row.pairs);
  }
}

}  // namespace
}  // namespace posecoach
