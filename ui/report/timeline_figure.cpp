#include "ui/report/timeline_figure.h"

#include <algorithm>
#include <cmath>

#include "ui/render/words.h"
#include "ui/report/html.h"

namespace posecoach::report {
namespace {

constexpr double kFigureHeight = 104;  // of a row of bodies
constexpr double kLabelHeight = 20;
constexpr double kLinkHeight = 84;
constexpr double kLeader = 20;  // from a body to its time line
constexpr std::size_t kMostLinks = 80;
constexpr int kMostColumns = 9;

std::string n(double value) {
  return decimal(value, 1);
}

struct Column {
  int step = 0;
  std::string label;
  double x = 0;
};

// The student's events where they are known, else moments evenly over the motion.
std::vector<Column> columns(const Analysis& analysis, const Replay& replay, const TimelineAxis& axis) {
  std::vector<Column> columns;
  const int last = static_cast<int>(replay.steps.size()) - 1;
  for (const SwingEvent& event : analysis.student_events) {
    const int step = step_at(replay, event.frame, 0);
    if (event.frame < replay.steps.front().student_frame || event.frame > replay.steps.back().student_frame)
      continue;
    if (!columns.empty() && columns.back().step >= step) continue;
    columns.push_back({step, title_from_name(event.name), 0});
  }
  if (columns.size() < 2 || columns.size() > static_cast<std::size_t>(kMostColumns)) {
    columns.clear();
    const int count = std::min(last + 1, kMostColumns - 1);
    for (int i = 0; i < count; ++i) columns.push_back({count == 1 ? 0 : i * last / (count - 1), "", 0});
  }
  const double pitch = (axis.right - axis.left) / static_cast<double>(columns.size());
  for (std::size_t i = 0; i < columns.size(); ++i)
    columns[i].x = axis.left + (static_cast<double>(i) + 0.5) * pitch;
  return columns;
}

// A body seen from the front, standing on `floor`.
std::string body(const Replay& replay, const std::vector<Vec3>& joints, double x, double floor, double scale,
                 std::string_view look) {
  double middle = 0;
  for (const Vec3& p : joints) middle += p.x / static_cast<double>(joints.size());
  const auto px = [&](int joint) {
    return n(x + scale * (joints[static_cast<std::size_t>(joint)].x - middle));
  };
  const auto py = [&](int joint) { return n(floor - scale * joints[static_cast<std::size_t>(joint)].y); };
  std::string path;
  for (const auto& [a, b] : replay.bones) path += "M" + px(a) + " " + py(a) + "L" + px(b) + " " + py(b);
  std::string head;
  const auto found = std::find(replay.joints.begin(), replay.joints.end(), HumanoidJoint::Head);
  if (found != replay.joints.end()) {
    const int joint = static_cast<int>(found - replay.joints.begin());
    head = "<circle cx=\"" + px(joint) + "\" cy=\"" + py(joint) + "\" r=\"" + n(0.085 * scale) + "\"/>";
  }
  return "<g class=\"body " + std::string(look) + "\"><path d=\"" + path + "\"/>" + head + "</g>";
}

double tallest(const Replay& replay) {
  double top = 1;
  for (const ReplayStep& step : replay.steps)
    for (const std::vector<Vec3>* joints : {&step.student, &step.coach})
      for (const Vec3& p : *joints) top = std::max(top, p.y);
  return top;
}

std::string line(double x1, double y1, double x2, double y2, std::string_view look) {
  return "<line class=\"" + std::string(look) + "\" x1=\"" + n(x1) + "\" y1=\"" + n(y1) + "\" x2=\"" + n(x2) +
         "\" y2=\"" + n(y2) + "\"/>";
}

std::string text(double x, double y, std::string_view words, std::string_view look) {
  return "<text class=\"" + std::string(look) + "\" x=\"" + n(x) + "\" y=\"" + n(y) + "\">" +
         html::escape(words) + "</text>";
}

std::string links(const Replay& replay, const TimelineAxis& axis) {
  std::string path;
  const std::size_t count = replay.steps.size(), kept = std::min(count, kMostLinks);
  for (std::size_t i = 0; i < kept; ++i) {
    const ReplayStep& step = replay.steps[kept == 1 ? 0 : i * (count - 1) / (kept - 1)];
    path += "M" + n(axis.student_x(step.student_s)) + " " + n(axis.student_y) + "L" +
            n(axis.coach_x(step.coach_s)) + " " + n(axis.coach_y);
  }
  return "<path class=\"links\" d=\"" + path + "\"/>";
}

// Mean distance over the student's time, as an area.
std::string distance_area(const Replay& replay, const TimelineAxis& axis, double top, double height) {
  double largest = 0.05;
  for (const ReplayStep& step : replay.steps) largest = std::max(largest, step.apart_m);
  std::string path = "M" + n(axis.student_x(replay.steps.front().student_s)) + " " + n(top + height);
  for (const ReplayStep& step : replay.steps)
    path += "L" + n(axis.student_x(step.student_s)) + " " + n(top + height * (1 - step.apart_m / largest));
  path += "L" + n(axis.student_x(replay.steps.back().student_s)) + " " + n(top + height) + "Z";
  return text(axis.left - 10, top + 0.5 * height + 4, "Apart", "row") + "<path class=\"area\" d=\"" + path +
         "\"/>" + text(axis.right, top - 5, "up to " + decimal(100 * largest, 0) + " cm", "scale");
}

// Colour by the student's speed against the coach's; equal within a tenth stays grey.
std::string speed_ribbon(const Replay& replay, const TimelineAxis& axis, double top, double height) {
  std::string cells;
  std::size_t begin = 0;
  const auto tone = [&](std::size_t i) {
    const double speed = replay.speed_in_proportion(replay.steps[i]);
    return speed > 1.5 ? 2 : speed > 1.1 ? 1 : speed < 1 / 1.5 ? -2 : speed < 1 / 1.1 ? -1 : 0;
  };
  const auto look = [](int t) {
    return t == 2 ? "much-faster" : t == 1 ? "faster" : t == -1 ? "slower" : t == -2 ? "much-slower" : "same";
  };
  for (std::size_t i = 0; i <= replay.steps.size(); ++i) {
    const bool ends = i == replay.steps.size() || (i > begin && tone(i) != tone(begin));
    if (!ends) continue;
    const double from = axis.student_x(replay.steps[begin].student_s);
    const double to = axis.student_x(replay.steps[std::min(i, replay.steps.size() - 1)].student_s);
    if (to > from)
      cells += "<rect class=\"" + std::string(look(tone(begin))) + "\" x=\"" + n(from) + "\" y=\"" + n(top) +
               "\" width=\"" + n(to - from) + "\" height=\"" + n(height) + "\"/>";
    begin = i;
  }
  return text(axis.left - 10, top + 0.5 * height + 4, "Speed", "row") + cells;
}

}  // namespace

double TimelineAxis::student_x(double seconds) const {
  const double span = student_end_s - student_begin_s;
  return left + (span > 0 ? (seconds - student_begin_s) / span : 0.5) * (right - left);
}

double TimelineAxis::coach_x(double seconds) const {
  const double span = coach_end_s - coach_begin_s;
  return left + (span > 0 ? (seconds - coach_begin_s) / span : 0.5) * (right - left);
}

TimelineAxis timeline_axis(const Replay& replay) {
  TimelineAxis axis;
  axis.student_y = kLabelHeight + kFigureHeight + kLeader;
  axis.coach_y = axis.student_y + kLinkHeight;
  if (replay.steps.empty()) return axis;
  axis.student_begin_s = replay.steps.front().student_s;
  axis.student_end_s = replay.steps.back().student_s;
  axis.coach_begin_s = replay.steps.front().coach_s;
  axis.coach_end_s = replay.steps.back().coach_s;
  return axis;
}

std::string timeline_figure(const Analysis& analysis, const Replay& replay) {
  if (replay.steps.empty()) return {};
  const TimelineAxis axis = timeline_axis(replay);
  const double scale = 0.94 * kFigureHeight / tallest(replay);
  const double coach_floor = axis.coach_y + kLeader + kFigureHeight;
  const double chart_top = coach_floor + 34, chart_height = 44, ribbon_top = chart_top + chart_height + 12;
  const double height = ribbon_top + 22;

  std::string svg = "<svg id=\"timeline\" viewBox=\"0 0 1000 " + n(height) +
                    "\" role=\"img\" aria-label=\"Which moment of you answers which moment of the coach\">";
  svg += links(replay, axis);
  for (const Column& column : columns(analysis, replay, axis)) {
    const ReplayStep& step = replay.steps[static_cast<std::size_t>(column.step)];
    const double his = axis.student_x(step.student_s), coachs = axis.coach_x(step.coach_s);
    svg += "<g class=\"column\" data-step=\"" + std::to_string(column.step) + "\">";
    svg += text(column.x, 12, column.label, "label");
    svg += line(column.x, kLabelHeight + kFigureHeight + 3, his, axis.student_y, "leader");
    svg += line(column.x, axis.coach_y + kLeader - 3, coachs, axis.coach_y, "leader");
    svg += line(his, axis.student_y, coachs, axis.coach_y, "event-link");
    svg += body(replay, step.student, column.x, kLabelHeight + kFigureHeight, scale, "student");
    svg += body(replay, step.coach, column.x, coach_floor, scale, "coach");
    svg += "<circle class=\"student\" cx=\"" + n(his) + "\" cy=\"" + n(axis.student_y) + "\" r=\"4\"/>";
    svg += "<circle class=\"coach\" cx=\"" + n(coachs) + "\" cy=\"" + n(axis.coach_y) + "\" r=\"4\"/></g>";
  }
  svg += line(axis.left, axis.student_y, axis.right, axis.student_y, "track student");
  svg += line(axis.left, axis.coach_y, axis.right, axis.coach_y, "track coach");
  svg += text(axis.left - 10, axis.student_y + 4, "You", "row student");
  svg += text(axis.left - 10, axis.coach_y + 4, "Coach", "row coach");
  svg += distance_area(replay, axis, chart_top, chart_height);
  svg += speed_ribbon(replay, axis, ribbon_top, 12);
  svg += "<g id=\"now\">" + line(0, 0, 0, 0, "now-link") +
         line(0, chart_top - 6, 0, ribbon_top + 14, "now-line") +
         "<circle class=\"student\" r=\"7\"/><circle class=\"coach\" r=\"7\"/></g>";
  return svg + "</svg>";
}

}  // namespace posecoach::report
