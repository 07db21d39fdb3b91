#include "core/coaching/summary.h"

#include <fmt/core.h>
#include <algorithm>

namespace posecoach {
namespace {

const Metric* find_metric(const Analysis& analysis, std::string_view name) {
  for (const Metric& metric : analysis.metrics)
    if (metric.name == name && metric.available) return &metric;
  return nullptr;
}

std::string score_line(const Score& score) {
  const std::string doubt = score.plus_minus >= 0.5 ? fmt::format(" ± {:.0f}", score.plus_minus) : "";
  return fmt::format(
      "Score {:.0f}{} of 100: on average a joint is {:.1f} cm from the coach's (raw {:.2f}, lower is "
      "better).\n",
      score.percent, doubt, 100 * score.mean_joint_error_m, score.raw);
}

}  // namespace

std::string summary(const Analysis& analysis) {
  const std::string hand = analysis.student.hand == Handedness::Left ? "left-handed " : "right-handed ";
  std::string lines = fmt::format("{}: a {}{}, {:.1f} s, against {}.\n", analysis.student.source, hand,
                                  analysis.stroke, analysis.student.seconds, analysis.coach.source);
  lines += score_line(analysis.score);
  if (const Metric* tempo = find_metric(analysis, "tempo_ratio"))
    lines += fmt::format("Tempo {:.1f} ± {:.1f} to 1, the coach's {:.1f} to 1.\n", tempo->value,
                         tempo->plus_minus, tempo->coach.value_or(0));
  lines += "\n";
  int number = 0;
  for (const Advice& advice : analysis.advice) {
    if (advice.kind == AdviceKind::None)
      lines += advice.text + "\n";
    else
      lines += fmt::format("{}. {} (frame {}, coach {})\n", ++number, advice.text, advice.student_frame,
                           advice.coach_frame);
  }
  for (const std::string& note : analysis.notes) lines += "Note: " + note + "\n";
  return lines;
}

}  // namespace posecoach
