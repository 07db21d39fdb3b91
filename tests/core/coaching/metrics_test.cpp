// Metrics against what the authored strokes are known to do.
#include "core/coaching/metrics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/coaching/compare.h"
#include "core/coaching/kinematic_sequence.h"
#include "core/coaching/text/metric_text.h"
#include "core/motion/authored/golf_fault.h"
#include "tests/core/coaching/strokes.h"

namespace posecoach {
namespace {

Analysis analyzed(const Motion& student, const Motion& coach, const CompareOptions& options = {}) {
  const Result<Analysis> analysis = compare(student, coach, options);
  EXPECT_TRUE(analysis) << (analysis ? "" : analysis.error().message);
  return *analysis;
}

const Metric& metric(const Analysis& analysis, std::string_view name) {
  const auto found = std::find_if(analysis.metrics.begin(), analysis.metrics.end(),
                                  [&](const Metric& m) { return m.name == name; });
  EXPECT_NE(found, analysis.metrics.end()) << name;
  return *found;
}

Motion faulty(std::string_view fault, double amount, double fps = 120) {
  const FaultChoice choice = choose_fault(fault, amount).value();
  GolfScript script = bundled_script(choice.fault->motion).value();
  EXPECT_TRUE(apply_fault(script, choice));
  return make_stroke(script, {choice.fault->motion, fps, {.height_m = 1.80}, Handedness::Right}).motion;
}

Motion sound(std::string_view name, double fps = 120) {
  return make_stroke({name, fps, {.height_m = 1.80}, Handedness::Right}).motion;
}

TEST(Metrics, of_the_bundled_strokes_lie_in_good_golfers_ranges) {
  for (const char* name : {"swing", "putt"}) {
    const Analysis analysis = analyzed(sound(name), sound(name));
    for (const char* within : {"tempo_ratio", "backswing_s", "downswing_s", "shoulder_turn_top_deg",
                               "hip_turn_top_deg", "hip_turn_impact_deg", "sway_top_cm", "shoulder_rock_deg",
                               "follow_through_ratio", "total_time_s"}) {
      const auto found = std::find_if(analysis.metrics.begin(), analysis.metrics.end(),
                                      [&](const Metric& m) { return m.name == within; });
      if (found == analysis.metrics.end()) continue;
      ASSERT_TRUE(found->usual.has_value()) << within;
      const double slack = found->plus_minus + 0.05 * std::abs(found->value);
      EXPECT_GE(found->value, found->usual->first - slack) << name << " " << within;
      EXPECT_LE(found->value, found->usual->second + slack) << name << " " << within;
      EXPECT_FALSE(found->source.empty()) << within;
    }
  }
}

TEST(Metrics, each_has_a_definition_and_an_uncertainty_or_a_reason) {
  for (const Viewpoint view : {Viewpoint::AllSides, Viewpoint::FaceOn, Viewpoint::DownTheLine})
    for (const char* name : {"swing", "putt"})
      for (const Metric& m : analyzed(sound(name, 60), sound(name), {.views = {view}}).metrics) {
        EXPECT_FALSE(m.definition.empty()) << m.name;
        EXPECT_NE(m.available, !m.reason.empty()) << m.name;
        if (m.available && m.words.empty()) {
          EXPECT_GT(m.plus_minus, 0) << m.name;
        }
      }
}

TEST(Metrics, move_with_the_fault_that_they_measure_by_about_its_amount) {
  struct Case {
    const char *fault, *metric;
    double amount, change, tolerance;
  };
  for (const Case& one :
       {Case{"sway", "sway_top_cm", 10, -10, 1.0}, Case{"slide", "slide_impact_cm", 10, 10, 1.5},
        Case{"early_extension", "thrust_impact_cm", 8, 8, 1.5},
        Case{"bent_lead_arm", "lead_arm_bend_top_deg", 35, 35, 6},
        Case{"wrist_break", "wrist_break_deg", 30, 30, 6},
        Case{"reverse_spine_angle", "spine_side_top_deg", 15, -13, 4}}) {
    const char* stroke = std::string_view(one.fault) == "wrist_break" ? "putt" : "swing";
    const Analysis analysis = analyzed(faulty(one.fault, one.amount), sound(stroke));
    const Metric& m = metric(analysis, one.metric);
    ASSERT_TRUE(m.coach.has_value());
    EXPECT_NEAR(m.value - *m.coach, one.change, one.tolerance) << one.fault;
  }
}

TEST(Metrics, a_head_that_moves_with_the_putter_is_told_from_one_that_is_still) {
  const Metric moving =
      metric(analyzed(faulty("head_moves_with_putter", 6), sound("putt")), "head_hands_coupling");
  EXPECT_TRUE(moving.available) << moving.reason;
  EXPECT_GT(moving.value, 0.8);
  EXPECT_EQ(moving.words, "with the hands");
}

TEST(KinematicSequence, of_the_bundled_swing_runs_from_the_ground_up_at_120_frames_a_second) {
  const Analysis analysis = analyzed(sound("swing", 240), sound("swing"));
  const Metric& sequence = metric(analysis, "kinematic_sequence");
  EXPECT_TRUE(sequence.available) << sequence.reason;
  EXPECT_EQ(sequence.words, "pelvis, chest, lead arm");
  EXPECT_EQ(sequence.value, 1);
  EXPECT_LT(metric(analysis, "pelvis_peak_deg_s").value, metric(analysis, "chest_peak_deg_s").value);
}

TEST(KinematicSequence, is_not_told_from_frames_that_are_further_apart_than_the_peaks) {
  const Analysis analysis = analyzed(sound("swing", 30), sound("swing"));
  const Metric& sequence = metric(analysis, "kinematic_sequence");
  EXPECT_FALSE(sequence.available);
  EXPECT_NE(sequence.reason.find("cannot tell"), std::string::npos) << sequence.reason;
  EXPECT_FALSE(metric(analysis, "pelvis_peak_deg_s").available);
}

TEST(KinematicSequence, is_never_told_from_one_camera) {
  const Analysis analysis = analyzed(sound("swing", 240), sound("swing"), {.views = {Viewpoint::FaceOn}});
  EXPECT_FALSE(metric(analysis, "kinematic_sequence").available);
}

TEST(KinematicSequence, sees_an_arm_that_runs_ahead_of_the_chest) {
  GolfScript script = bundled_script("swing").value();
  // The chest hangs back and catches up late.
  const std::vector<GolfScript::Offset> late = {{"top", 0},    {"mid_downswing", -24}, {"delivery", -30},
                                                {"impact", 0}, {"release", 10},        {"wrap", 0}};
  script.add(GolfChannel::ChestTurn, late);
  const StrokeShape shape{"swing", 240, {.height_m = 1.80}, Handedness::Right};
  const JointTrack track = JointTrack::from_motion(make_stroke(script, shape).motion).value();
  const KinematicSequence sequence = kinematic_sequence(track, find_swing_events(track).value());
  const auto at = [&](Segment segment) {
    return sequence.peaks[static_cast<std::size_t>(segment)].before_impact_s;
  };
  EXPECT_LT(at(Segment::Chest), at(Segment::Pelvis));
  EXPECT_FALSE(sequence.is_from_the_ground_up());
}

}  // namespace
}  // namespace posecoach
