#include <algorithm>
#include <cmath>

#include "ui/render/words.h"
#include "ui/report/html.h"
#include "ui/report/page_pieces.h"
#include "ui/report/report_sections.h"

namespace posecoach::report {
namespace {

std::string bars(std::string_view title, const std::vector<PartScore>& parts) {
  if (parts.empty()) return {};
  std::string rows;
  for (const PartScore& part : parts) {
    const std::string percent = decimal(part.percent, 0);
    rows += "<div class=\"bar\"><span>" + html::escape(title_from_name(part.name)) +
            "</span><span class=\"rail\"><i class=\"" + std::string(grade(part.percent)) +
            "\" style=\"width:" + decimal(std::clamp(part.percent, 0.0, 100.0), 1) +
            "%\"></i></span><span class=\"number\">" + percent + " <small>" +
            centimetres(part.mean_joint_error_m) + "</small></span></div>";
  }
  return "<div><h3>" + std::string(title) + "</h3><div class=\"bars\">" + rows + "</div></div>";
}

}  // namespace

std::string parts_section(const Analysis& analysis) {
  const std::string body =
      bars("Your body", analysis.score.groups) + bars("Your swing", analysis.score.phases);
  return section("parts", "Where the score comes from",
                 body.empty() ? body : "<div class=\"parts\">" + body + "</div>",
                 "Each part scored by itself, of 100, and how far a joint of it is from the coach’s on "
                 "average. The two are "
                 "laid hips over hips: how far your hips move shows in the other parts.");
}

}  // namespace posecoach::report
