#include "core/coaching/block.h"

#include <algorithm>
#include <cmath>

#include "core/coaching/text/advice_text.h"

namespace posecoach {
namespace {

struct Collected {
  MetricSpread metric;
  std::vector<double> values;
};

std::vector<MetricSpread> metrics_of(std::span<const BlockSwing> swings) {
  std::vector<Collected> collected;
  for (const BlockSwing& swing : swings)
    for (const Metric& metric : swing.metrics) {
      if (!metric.available || !std::isfinite(metric.value)) continue;
      auto found = std::find_if(collected.begin(), collected.end(),
                                [&](const Collected& c) { return c.metric.name == metric.name; });
      if (found == collected.end()) {
        collected.push_back({{metric.name, metric.title, metric.unit, {}, metric.coach}, {}});
        found = collected.end() - 1;
      }
      found->values.push_back(metric.value);
    }
  std::vector<MetricSpread> metrics;
  for (Collected& one : collected) {
    one.metric.spread = spread_of(one.values);
    metrics.push_back(std::move(one.metric));
  }
  return metrics;
}

std::vector<RepeatedAdvice> advice_of(std::span<const BlockSwing> swings) {
  struct Counted {
    RepeatedAdvice advice;
    double severity = 0;
  };
  std::vector<Counted> counted;
  for (std::size_t s = 0; s < swings.size(); ++s)
    for (const Advice& advice : swings[s].advice) {
      if (advice.kind == AdviceKind::None) continue;
      // The same fault at another moment of the swing is the same fault.
      auto found = std::find_if(counted.begin(), counted.end(), [&](const Counted& c) {
        return advice.fault.empty() ? c.advice.fault.empty() && c.advice.measure == advice.measure &&
                                          c.advice.event == advice.event
                                    : c.advice.fault == advice.fault;
      });
      if (found == counted.end()) {
        counted.push_back({{advice.fault, advice.measure, advice.event, 0, {}, 0}, -1});
        found = counted.end() - 1;
      }
      ++found->advice.swings;
      if (advice.severity <= found->severity) continue;
      found->severity = advice.severity;
      found->advice.text = advice.text;
      found->advice.clearest_swing = static_cast<int>(s);
    }
  std::stable_sort(counted.begin(), counted.end(), [](const Counted& a, const Counted& b) {
    return a.advice.swings != b.advice.swings ? a.advice.swings > b.advice.swings : a.severity > b.severity;
  });
  std::vector<RepeatedAdvice> repeated;
  for (Counted& one : counted) repeated.push_back(std::move(one.advice));
  return repeated;
}

}  // namespace

BlockSwing block_swing_from(const Analysis& analysis) {
  return {analysis.stroke, analysis.score.percent, analysis.metrics, analysis.advice};
}

Spread spread_of(std::span<const double> values) {
  Spread spread;
  spread.count = static_cast<int>(values.size());
  if (values.empty()) return spread;
  for (const double value : values) spread.mean += value / spread.count;
  if (spread.count < 2) return spread;
  double squares = 0;
  for (const double value : values) squares += (value - spread.mean) * (value - spread.mean);
  spread.deviation = std::sqrt(squares / (spread.count - 1));
  return spread;
}

Block make_block(std::span<const BlockSwing> swings) {
  Block block;
  block.swings = static_cast<int>(swings.size());
  if (swings.empty()) return block;
  std::vector<double> percent;
  for (const BlockSwing& swing : swings) percent.push_back(swing.percent);
  block.percent = spread_of(percent);
  block.metrics = metrics_of(swings);
  block.advice = advice_of(swings);
  const bool repeats = !block.advice.empty() && 2 * block.advice.front().swings > block.swings;
  block.words = text::block(block.swings, block.percent.mean, block.percent.deviation,
                            repeats ? block.advice.front().text : std::string(),
                            repeats ? block.advice.front().swings : 0);
  return block;
}

}  // namespace posecoach
