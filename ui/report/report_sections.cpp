#include "ui/report/report_sections.h"

#include <algorithm>
#include <cmath>

#include "ui/render/words.h"
#include "ui/report/html.h"
#include "ui/report/page_pieces.h"

namespace posecoach::report {
namespace {

using html::escape;

std::string score_ring(double percent) {
  constexpr double kRadius = 52, kLength = 2 * 3.14159265358979 * kRadius;
  const double filled = kLength * std::clamp(percent, 0.0, 100.0) / 100;
  return "<svg class=\"ring " + std::string(grade(percent)) +
         "\" viewBox=\"0 0 120 120\" role=\"img\" aria-label=\"Overall match " + decimal(percent, 0) +
         " of 100\"><circle class=\"track\" cx=\"60\" cy=\"60\" r=\"52\"/><circle class=\"value\" cx=\"60\" "
         "cy=\"60\" r=\"52\" stroke-dasharray=\"" +
         decimal(filled, 1) + " " + decimal(kLength, 1) +
         "\" transform=\"rotate(-90 60 60)\"/><text x=\"60\" y=\"70\">" + decimal(percent, 0) +
         "</text><text class=\"of\" x=\"60\" y=\"88\">of 100</text></svg>";
}

std::string_view kind_word(AdviceKind kind) {
  switch (kind) {
    case AdviceKind::Timing:
      return "Timing";
    case AdviceKind::Spatial:
      return "Position";
    case AdviceKind::None:
      return "All good";
  }
  return "";
}

// Where there are published figures.
std::string usual_cell(const Metric& metric) {
  if (!metric.usual) return "<td></td>";
  const auto number = [](double value) { return decimal(value, value == std::round(value) ? 0 : 2); };
  std::string range = number(metric.usual->first) + " to " + number(metric.usual->second);
  for (std::size_t at = 0; (at = range.find('-', at)) != std::string::npos;) range.replace(at, 1, "−");
  return cell("Good golfers",
              range + (metric.unit == "deg" ? "°" : "") + "<small>" + escape(metric.source) + "</small>");
}

// With as many digits as the uncertainty leaves sense in.
int digits_for(const Metric& metric) {
  const double finest =
      metric.plus_minus > 0 ? metric.plus_minus : std::max(std::abs(metric.value), 1e-9) / 50;
  return finest >= 3 ? 0 : finest >= 0.2 ? 1 : 2;
}

}  // namespace

std::string summary_section(const Analysis& analysis, const Replay& replay) {
  std::string main = "<p class=\"headline\">No advice</p>";
  std::string others;
  for (std::size_t i = 0; i < analysis.advice.size(); ++i) {
    const Advice& advice = analysis.advice[i];
    const std::string kind = "<span class=\"chip\">" + std::string(kind_word(advice.kind)) + "</span>";
    const std::string button = advice.kind == AdviceKind::None
                                   ? ""
                                   : moment_button(replay, advice.student_frame, advice.coach_frame);
    if (i == 0)
      main = "<p class=\"eyebrow\">" +
             std::string(advice.kind == AdviceKind::None ? "The verdict" : "The one thing to change") +
             "</p><p class=\"headline\">" + escape(advice.text) + "</p><p>" + kind + button + "</p>";
    else
      others += "<li><p>" + escape(advice.text) + "</p><p>" + kind + button + "</p></li>";
  }
  if (!others.empty())
    others =
        "<div class=\"then\"><p class=\"eyebrow\">After that</p><ol start=\"2\">" + others + "</ol></div>";
  const Score& score = analysis.score;
  return "<section id=\"summary\"><div class=\"score\">" + score_ring(score.percent) +
         "<div><p class=\"eyebrow\">Overall match" +
         (score.plus_minus >= 0.5 ? " ±&nbsp;" + decimal(score.plus_minus, 0) : "") + "</p><p><b>" +
         centimetres(score.mean_joint_error_m) + "</b> apart a joint</p><p class=\"quiet\">Raw score " +
         decimal(score.raw, 2) + ", lower is better</p></div></div><div class=\"main\">" + main + "</div>" +
         others + "</section>\n";
}

std::string pictures_section(const Analysis& analysis, std::span<const ReportPicture> pictures,
                             const Replay& replay, Palette palette) {
  std::string body;
  for (const ReportPicture& picture : pictures) {
    if (picture.image.empty()) continue;
    double apart = -1;
    for (std::size_t i = 0; i < std::min(analysis.path.size(), analysis.path_error_m.size()); ++i)
      if (analysis.path[i].first == picture.student_frame) apart = std::max(apart, analysis.path_error_m[i]);
    body += "<figure><img alt=\"" + escape(picture.caption) + "\" width=\"" +
            std::to_string(picture.image.width) + "\" height=\"" + std::to_string(picture.image.height) +
            "\" src=\"" + html::jpeg_uri(picture.image) + "\"><figcaption><b>" + escape(picture.caption) +
            "</b><span class=\"quiet\">";
    if (apart >= 0) body += centimetres(apart) + " a joint, ";
    body += "your frame " + std::to_string(picture.student_frame) + ", coach’s " +
            std::to_string(picture.coach_frame) + "</span>" +
            moment_button(replay, picture.student_frame, picture.coach_frame) + "</figcaption></figure>";
  }
  if (!body.empty()) body = "<div class=\"pictures\">" + body + "</div>";
  return section("pictures", "See the difference", body,
                 palette == Palette::RedGreen
                     ? "You in <span class=\"student\">green</span>, the coach in your body in <span "
                       "class=\"coach\">red</span>."
                     : "You in <span class=\"student\">blue</span>, the coach in your body in <span "
                       "class=\"coach\">orange bands</span>.");
}

std::string joints_section(const Analysis& analysis) {
  double largest = 0.01;
  for (const JointError& error : analysis.joint_errors) largest = std::max(largest, error.max_m);
  std::string rows;
  for (const JointError& error : analysis.joint_errors) {
    if (error.max_m <= 0) continue;  // where the bodies are pinned together there is nothing to tell
    const auto share = [&](double metres) {
      return decimal(100 * std::clamp(metres / largest, 0.0, 1.0), 1);
    };
    rows += "<div class=\"bar\"><span>" + escape(title_from_name(error.joint)) +
            "</span><span class=\"rail\"><i class=\"most\" style=\"width:" + share(error.max_m) +
            "%\"></i><i class=\"mean\" style=\"width:" + share(error.mean_m) +
            "%\"></i></span><span class=\"number\">" + centimetres(error.mean_m) + "</span></div>";
  }
  if (!rows.empty()) rows = "<div class=\"bars\">" + rows + "</div>";
  return section("joints", "Joint by joint", rows,
                 "Mean distance from the coach over the whole motion; the pale part reaches to the largest.");
}

std::string timing_section(const Analysis& analysis, const Replay& replay) {
  std::string rows;
  for (const TimingAdvice& timing : analysis.timing) {
    const bool known = std::isfinite(timing.ratio) && timing.ratio > 0;
    const double compared = replay.is_in_proportion() ? timing.ratio * replay.overall_speed : timing.ratio;
    const std::string_view tone = !known || std::abs(compared - 1) < 0.1 ? "same"
                                  : compared < 1                         ? "faster"
                                                                         : "slower";
    std::string ratio = "<span class=\"tone " + std::string(tone) + "\">";
    ratio += known ? "×&nbsp;" + decimal(timing.ratio, 2) + "</span>" : "–</span>";
    if (known && timing.plus_minus > 0)
      ratio += " <span class=\"pm\">±&nbsp;" + decimal(timing.plus_minus, 2) + "</span>";
    rows += "<tr><th scope=\"row\">" + escape(title_from_name(timing.from)) + " → " +
            escape(title_from_name(timing.to)) + "</th>" +
            cell("You", decimal(timing.student_s, 2) + "&nbsp;s") +
            cell("Coach", decimal(timing.coach_s, 2) + "&nbsp;s") + cell("Ratio", ratio) +
            "<td class=\"wide\">" + escape(timing.advice) + "</td></tr>";
  }
  if (!rows.empty())
    rows =
        "<div class=\"scroll\"><table><thead><tr><th>Part</th><th>You</th><th>Coach</th><th>Ratio</th><th "
        "class=\"wide\">What to do</th></tr></thead><tbody>" +
        rows + "</tbody></table></div>";
  return section("timing", "Timing", rows);
}

std::string spatial_section(const Analysis& analysis, const Replay& replay) {
  std::string rows;
  for (const SpatialAdvice& spatial : analysis.spatial)
    rows += "<tr><th scope=\"row\">" + escape(title_from_name(spatial.joint)) + "</th>" +
            cell("At", escape(title_from_name(spatial.event))) +
            cell("Off by", centimetres(spatial.distance_m)) + "<td class=\"wide\">" + escape(spatial.advice) +
            " " + moment_button(replay, spatial.student_frame, spatial.coach_frame) + "</td></tr>";
  if (!rows.empty())
    rows =
        "<div class=\"scroll\"><table><thead><tr><th>Joint</th><th>At</th><th>Off by</th><th "
        "class=\"wide\">What to do</th></tr></thead><tbody>" +
        rows + "</tbody></table></div>";
  return section("positions", "Positions", rows);
}

std::string metrics_section(const Analysis& analysis) {
  std::string rows;
  for (const Metric& metric : analysis.metrics) {
    const bool available = metric.available && std::isfinite(metric.value);
    const int digits = digits_for(metric);
    std::string definition = escape(metric.definition);
    if (!definition.empty()) definition = "<small>" + definition + "</small>";
    rows += std::string("<tr") + (available ? "" : " class=\"off\"") + "><th scope=\"row\">" +
            escape(metric.title.empty() ? title_from_name(metric.name) : metric.title) + definition + "</th>";
    if (!available) {
      rows += "<td colspan=\"3\">– <span class=\"reason\">" + escape(metric.reason) + "</span></td></tr>";
      continue;
    }
    rows += "<td data-label=\"You\"><b>" + in_unit(metric.value, digits, metric.unit) + "</b>";
    if (metric.plus_minus > 0)
      rows += " <span class=\"pm\">±&nbsp;" + decimal(metric.plus_minus, digits) + "</span>";
    rows += "</td>";
    if (metric.coach && std::isfinite(*metric.coach))
      rows += cell("Coach", in_unit(*metric.coach, digits, metric.unit));
    else
      rows += "<td></td>";
    rows += usual_cell(metric) + "</tr>";
  }
  if (!rows.empty())
    rows =
        "<div class=\"scroll\"><table class=\"metrics\"><thead><tr><th>Measurement</th><th>You</th><th>Coach "
        "in your body</th><th>Good golfers</th></tr></thead><tbody>" +
        rows + "</tbody></table></div>";
  return section("metrics", "Measurements", rows,
                 "With the uncertainty of the recording. What it cannot show is left out, with the reason.");
}

std::string method_section(const Analysis& analysis) {
  std::string notes;
  for (const std::string& note : analysis.notes) notes += "<li>" + escape(note) + "</li>";
  if (!notes.empty()) notes = "<ul>" + notes + "</ul>";
  const auto motion = [](std::string_view who, const MotionSummary& summary) {
    return "<dt>" + std::string(who) + "</dt><dd>" + escape(summary.source) + "<span class=\"quiet\"> – " +
           std::to_string(summary.frames) + " frames, " + decimal(summary.seconds, 2) + " s, " +
           std::to_string(summary.joints) + " joints" +
           (summary.hand ? *summary.hand == Handedness::Left ? ", left-handed" : ", right-handed" : "") +
           "</span></dd>";
  };
  return section("method", "Notes and method",
                 notes + "<dl>" + motion("You", analysis.student) + motion("Coach", analysis.coach) +
                     "<dt>Coach in your body</dt><dd>Method “" + escape(analysis.retarget_method) +
                     "”, bone lengths within " + decimal(100 * analysis.bone_length_error_max, 3) +
                     "&nbsp;%</dd><dt>Score</dt><dd>Both motions are matched moment by moment (dynamic time "
                     "warping) with the "
                     "pelvis in one place and facing the same way. The raw score is the sum of all joint "
                     "distances along the "
                     "match: lower is better.</dd></dl>");
}

}  // namespace posecoach::report
