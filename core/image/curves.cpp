#include "core/image/curves.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/assert.h"
#include "core/base/file.h"

namespace posecoach {
namespace {

constexpr int kPanelWidth = 460, kPanelHeight = 240, kMargin = 64, kAcross = 2;
const cv::Scalar kPaper(255, 255, 255), kAxis(200, 200, 200), kText(60, 60, 60), kCurve(160, 90, 20);

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

void write_text(cv::Mat& picture, const std::string& text, cv::Point where) {
  cv::putText(picture, text, where, cv::FONT_HERSHEY_SIMPLEX, 0.38, kText, 1, cv::LINE_AA);
}

void write_text_up_to(cv::Mat& picture, const std::string& text, cv::Point end) {
  int below = 0;
  const cv::Size size = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, 0.38, 1, &below);
  write_text(picture, text, {end.x - size.width, end.y});
}

void draw_panel(cv::Mat& picture, cv::Rect place, const std::string& axis, const std::string& name,
                const std::vector<cv::Point2d>& points) {
  double low = points.front().y, high = low;
  for (const cv::Point2d& p : points) {
    low = std::min(low, p.y);
    high = std::max(high, p.y);
  }
  if (high - low < 1e-12) high = low + 1;
  const double first = points.front().x, last = std::max(points.back().x, first + 1e-9);
  const cv::Rect inner(place.x + kMargin, place.y + 24, place.width - kMargin - 14, place.height - 52);
  cv::rectangle(picture, inner, kAxis);
  std::vector<cv::Point> line;
  for (const cv::Point2d& p : points)
    line.emplace_back(inner.x + static_cast<int>((p.x - first) / (last - first) * inner.width),
                      inner.y + static_cast<int>((high - p.y) / (high - low) * inner.height));
  cv::polylines(picture, line, false, kCurve, 1, cv::LINE_AA);
  write_text(picture, name + ": " + short_number(points.back().y), {inner.x, inner.y - 8});
  write_text_up_to(picture, short_number(high), {inner.x - 6, inner.y + 8});
  write_text_up_to(picture, short_number(low), {inner.x - 6, inner.y + inner.height});
  write_text(picture, short_number(first), {inner.x, inner.y + inner.height + 16});
  write_text_up_to(picture, axis + " " + short_number(last),
                   {inner.x + inner.width, inner.y + inner.height + 16});
}

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  while (true) {
    const std::size_t comma = line.find(',');
    cells.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

std::vector<double> numbers_of(std::string_view line) {
  std::vector<double> numbers;
  for (const std::string_view cell : cells_of(line)) {
    double number = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
    if (error != std::errc() || end != cell.data() + cell.size()) return {};
    numbers.push_back(number);
  }
  return numbers;
}

}  // namespace

CurveTable curves_from_csv(std::string_view csv) {
  CurveTable table;
  while (!csv.empty()) {
    const std::size_t end = csv.find('\n');
    const std::string_view line = csv.substr(0, end);
    csv.remove_prefix(end == std::string_view::npos ? csv.size() : end + 1);
    if (table.columns.empty()) {
      for (const std::string_view cell : cells_of(line)) table.columns.emplace_back(cell);
    } else if (std::vector<double> row = numbers_of(line); row.size() == table.columns.size()) {
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

Result<void> write_curves(const std::filesystem::path& picture, const CurveTable& table) {
  if (table.rows.empty() || table.columns.size() < 2) return {};
  const int panels = static_cast<int>(table.columns.size()) - 1;
  cv::Mat drawing(((panels + kAcross - 1) / kAcross) * kPanelHeight, kAcross * kPanelWidth, CV_8UC3, kPaper);
  for (int panel = 0; panel < panels; ++panel) {
    const std::size_t column = static_cast<std::size_t>(panel) + 1;
    std::vector<cv::Point2d> points;
    for (const std::vector<double>& row : table.rows) {
      POSECOACH_ASSERT(row.size() == table.columns.size());
      if (std::isfinite(row[column])) points.emplace_back(row[0], row[column]);
    }
    if (points.empty()) continue;
    const cv::Rect place((panel % kAcross) * kPanelWidth, (panel / kAcross) * kPanelHeight, kPanelWidth,
                         kPanelHeight);
    draw_panel(drawing, place, table.columns[0], table.columns[column], points);
  }
  std::vector<unsigned char> png;
  cv::imencode(".png", drawing, png);
  return write_file_atomically(picture, {reinterpret_cast<const char*>(png.data()), png.size()});
}

}  // namespace posecoach
