// Every fault that the authored strokes know, through true joints: it must be told first, by its own name.
#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "core/coaching/compare.h"
#include "core/motion/authored/golf_fault.h"
#include "tests/core/coaching/strokes.h"

namespace posecoach {
namespace {

struct Expected {
  const char* fault;
  AdviceKind kind;
  // Any of these in the first advice's words, and this event or phase.
  std::vector<std::string> words;
  std::string moment;
};

void PrintTo(const Expected& one, std::ostream* out) {
  *out << one.fault;
}

const std::vector<Expected>& expected_advice() {
  static const std::vector<Expected> all = {
      {"sway", AdviceKind::Spatial, {"hips"}, "At the top"},
      {"slide", AdviceKind::Spatial, {"hips"}, "At impact"},
      {"early_extension", AdviceKind::Spatial, {"hips"}, "At impact"},
      {"loss_of_posture", AdviceKind::Spatial, {"standing up"}, "At impact"},
      {"reverse_spine_angle", AdviceKind::Spatial, {"leans"}, "At the top"},
      {"chicken_wing", AdviceKind::Spatial, {"lead arm", "lead elbow"}, "After impact"},
      {"bent_lead_arm", AdviceKind::Spatial, {"lead arm"}, "At the top"},
      {"over_the_top", AdviceKind::Spatial, {"over the top"}, "Halfway down"},
      {"quick_transition", AdviceKind::Timing, {"too quick"}, "transition"},
      {"slow_backswing", AdviceKind::Timing, {"too slow"}, "backswing"},
      {"head_lift", AdviceKind::Spatial, {"head"}, "At impact"},
      {"flat_shoulder_turn", AdviceKind::Spatial, {"flat"}, "At the top"},
      {"head_moves_with_putter", AdviceKind::Spatial, {"head"}, "At the"},
      {"uneven_tempo", AdviceKind::Timing, {"too slow"}, "to the ball"},
  };
  return all;
}

Analysis analyzed(const Expected& expected, double part_of_default, double fps, double height_m,
                  Handedness hand) {
  const FaultChoice plain = choose_fault(expected.fault).value();
  const FaultChoice choice = choose_fault(expected.fault, part_of_default * plain.amount).value();
  GolfScript script = bundled_script(choice.fault->motion).value();
  EXPECT_TRUE(apply_fault(script, choice).has_value());
  const StrokeShape shape{choice.fault->motion, 120, {.height_m = height_m}, hand};
  StrokeShape student_shape = shape;
  student_shape.frames_per_second = fps;
  const Result<Analysis> analysis =
      compare(make_stroke(script, student_shape).motion, make_stroke(shape).motion);
  EXPECT_TRUE(analysis.has_value()) << (analysis ? "" : analysis.error().message);
  return analysis.value();
}

bool names(const Advice& advice, const Expected& expected) {
  if (advice.kind != expected.kind || advice.text.find(expected.moment) == std::string::npos) return false;
  return std::any_of(expected.words.begin(), expected.words.end(),
                     [&](const std::string& word) { return advice.text.find(word) != std::string::npos; });
}

class Fault : public testing::TestWithParam<Expected> {};

TEST_P(Fault, is_told_first_by_its_name_on_any_body_hand_and_frame_rate) {
  for (const auto& [fps, height, hand] :
       {std::tuple(30.0, 1.6, Handedness::Right), std::tuple(60.0, 1.95, Handedness::Left),
        std::tuple(120.0, 1.75, Handedness::Right)}) {
    const Analysis analysis = analyzed(GetParam(), 1, fps, height, hand);
    EXPECT_TRUE(names(analysis.advice[0], GetParam()))
        << GetParam().fault << " at " << fps << " fps, " << height << " m: " << analysis.advice[0].text;
    EXPECT_LE(analysis.advice.size(), 3U);
  }
}

TEST_P(Fault, scores_lower_the_larger_it_is) {
  const double whole = analyzed(GetParam(), 1, 120, 1.75, Handedness::Right).score.percent;
  const double half = analyzed(GetParam(), 0.5, 120, 1.75, Handedness::Right).score.percent;
  const double none = analyzed(GetParam(), 0, 120, 1.75, Handedness::Right).score.percent;
  // Tempo costs the path nothing but what the faster frames leave between them.
  if (GetParam().kind == AdviceKind::Timing) return;
  EXPECT_LT(whole, half);
  EXPECT_LT(half, none);
}

INSTANTIATE_TEST_SUITE_P(Known, Fault, testing::ValuesIn(expected_advice()),
                         [](const testing::TestParamInfo<Expected>& one) {
                           return std::string(one.param.fault);
                         });

}  // namespace
}  // namespace posecoach
