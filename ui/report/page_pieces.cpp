#include "ui/report/page_pieces.h"

#include "ui/render/words.h"
#include "ui/report/html.h"

namespace posecoach::report {

using html::escape;

std::string section(std::string_view id, std::string_view title, const std::string& body,
                    std::string_view lead) {
  if (body.empty()) return {};
  std::string result = "<section id=\"" + std::string(id) + "\"><h2>" + std::string(title) + "</h2>";
  if (!lead.empty()) result += "<p class=\"lead\">" + std::string(lead) + "</p>";
  return result + body + "</section>\n";
}

std::string moment_button(const Replay& replay, int student_frame, int coach_frame) {
  if (replay.steps.empty()) return {};
  return "<button type=\"button\" class=\"moment\" data-step=\"" +
         std::to_string(step_at(replay, student_frame, coach_frame)) + "\">Show the moment</button>";
}

std::string centimetres(double metres, int digits) {
  return decimal(100 * metres, digits) + "&nbsp;cm";
}

std::string in_unit(double value, int digits, std::string_view unit) {
  std::string number = decimal(value, digits);
  if (number.starts_with('-')) number.replace(0, 1, "−");
  return number + (unit == "deg" ? "°" : unit.empty() ? "" : "&nbsp;" + escape(unit));
}

std::string cell(std::string_view label, const std::string& content) {
  return "<td data-label=\"" + std::string(label) + "\">" + content + "</td>";
}

std::string_view grade(double percent) {
  return percent >= 85 ? "good" : percent >= 60 ? "fair" : "poor";
}

}  // namespace posecoach::report
