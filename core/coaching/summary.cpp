#include "core/coaching/summary.h"

#include <algorithm>

#include "core/coaching/text/advice_text.h"

namespace posecoach {

std::string summary(const Analysis& analysis) {
  std::string lines = text::summary_title(analysis) + "\n" + text::summary_score(analysis.score) + "\n";
  const auto tempo = std::find_if(analysis.metrics.begin(), analysis.metrics.end(), [](const Metric& metric) {
    return metric.name == "tempo_ratio" && metric.available;
  });
  if (tempo != analysis.metrics.end()) lines += text::summary_tempo(*tempo) + "\n";
  lines += "\n";
  int number = 0;
  for (const Advice& advice : analysis.advice)
    lines += (advice.kind == AdviceKind::None ? advice.text : text::summary_advice(++number, advice)) + "\n";
  for (const std::string& note : analysis.notes) lines += text::summary_note(note) + "\n";
  return lines;
}

}  // namespace posecoach
