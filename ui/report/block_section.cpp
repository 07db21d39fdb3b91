#include <cmath>

#include "ui/render/words.h"
#include "ui/report/html.h"
#include "ui/report/page_pieces.h"
#include "ui/report/report_sections.h"

namespace posecoach::report {
namespace {

using html::escape;

int digits_for(double deviation) {
  return deviation >= 3 ? 0 : deviation >= 0.2 ? 1 : 2;
}

std::string repeated(const Block& block) {
  std::string rows;
  for (const RepeatedAdvice& advice : block.advice) {
    if (advice.swings < 2) continue;
    rows += "<li><b>" + std::to_string(advice.swings) + " of " + std::to_string(block.swings) + "</b> " +
            escape(advice.text) + "</li>";
  }
  return rows.empty() ? rows : "<h3>What comes again</h3><ul class=\"again\">" + rows + "</ul>";
}

std::string spreads(const Block& block) {
  std::string rows;
  for (const MetricSpread& metric : block.metrics) {
    if (metric.spread.count < 2) continue;
    const int digits = digits_for(metric.spread.deviation);
    rows += "<tr><th scope=\"row\">" + escape(metric.title) + "</th>" +
            cell("Mean", "<b>" + in_unit(metric.spread.mean, digits, metric.unit) + "</b>") +
            cell("Spread", "±&nbsp;" + in_unit(metric.spread.deviation, digits, metric.unit)) +
            cell("Swings", std::to_string(metric.spread.count)) + "</tr>";
  }
  if (rows.empty()) return rows;
  return "<div class=\"scroll\"><table><thead><tr><th>Measurement</th><th>Mean</th><th>Spread</th><th>Swings"
         "</th></tr></thead><tbody>" +
         rows + "</tbody></table></div>";
}

}  // namespace

std::string block_section(const Block& block) {
  if (block.swings < 2) return {};
  const int digits = digits_for(block.percent.deviation);
  return section(
      "block", "Your last " + std::to_string(block.swings) + " swings",
      "<p class=\"spread\"><b>" + decimal(block.percent.mean, 0) + "</b> ±&nbsp;" +
          decimal(block.percent.deviation, digits) + " of 100</p>" + repeated(block) +
          "<details><summary>How even your swings are</summary>" + spreads(block) + "</details>",
      "One swing may lie; several tell what is yours. The smaller the spread, the more even your swing.");
}

}  // namespace posecoach::report
