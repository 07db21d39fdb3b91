#include "core/transfer/training_log.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "core/base/assert.h"
#include "core/base/file.h"

namespace posecoach {
namespace {

constexpr int kPanelWidth = 460, kPanelHeight = 240, kMargin = 44;
const cv::Scalar kPaper(255, 255, 255), kAxis(200, 200, 200), kText(60, 60, 60), kCurve(160, 90, 20);

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

void write_text(cv::Mat& picture, const std::string& text, cv::Point where) {
  cv::putText(picture, text, where, cv::FONT_HERSHEY_SIMPLEX, 0.38, kText, 1, cv::LINE_AA);
}

void draw_panel(cv::Mat& picture, cv::Rect place, const std::string& name,
                const std::vector<cv::Point2d>& points) {
  double low = points.front().y, high = low;
  for (const cv::Point2d& p : points) {
    low = std::min(low, p.y);
    high = std::max(high, p.y);
  }
  if (high - low < 1e-12) high = low + 1;
  const double first = points.front().x, last = std::max(points.back().x, first + 1);
  const cv::Rect inner(place.x + kMargin, place.y + 24, place.width - kMargin - 14, place.height - 52);
  cv::rectangle(picture, inner, kAxis);
  std::vector<cv::Point> line;
  for (const cv::Point2d& p : points)
    line.emplace_back(inner.x + static_cast<int>((p.x - first) / (last - first) * inner.width),
                      inner.y + static_cast<int>((high - p.y) / (high - low) * inner.height));
  cv::polylines(picture, line, false, kCurve, 1, cv::LINE_AA);
  write_text(picture, name + ": " + short_number(points.back().y), {inner.x, inner.y - 8});
  write_text(picture, short_number(high), {place.x + 2, inner.y + 8});
  write_text(picture, short_number(low), {place.x + 2, inner.y + inner.height});
  write_text(picture, short_number(last), {inner.x + inner.width - 40, inner.y + inner.height + 16});
}

}  // namespace

TransferTrainingLog::TransferTrainingLog(std::filesystem::path csv, std::vector<std::string> columns)
    : csv_(std::move(csv)), columns_(std::move(columns)) {}

Result<void> TransferTrainingLog::resume(double last) {
  const Result<std::string> text = read_file(csv_);
  if (!text) return text.error().code == ErrorCode::NotFound ? Result<void>{} : tl::unexpected(text.error());
  std::istringstream lines(*text);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream numbers(line);
    std::vector<double> row;
    for (double value = 0; numbers >> value;) row.push_back(value);
    if (row.size() == columns_.size() && row[0] <= last) rows_.push_back(std::move(row));
  }
  return {};
}

void TransferTrainingLog::add(std::vector<double> row) {
  POSECOACH_ASSERT(row.size() == columns_.size());
  rows_.push_back(std::move(row));
}

Result<void> TransferTrainingLog::write(const std::filesystem::path& picture) const {
  std::string text;
  for (const std::string& column : columns_) text += (text.empty() ? "" : ",") + column;
  text += '\n';
  for (const std::vector<double>& row : rows_) {
    std::string line;
    for (const double value : row) line += (line.empty() ? "" : ",") + short_number(value);
    text += line + '\n';
  }
  if (Result<void> written = write_file_atomically(csv_, text); !written) return written;
  if (rows_.empty()) return {};

  const int panels = static_cast<int>(columns_.size()) - 1, across = 2;
  cv::Mat drawing(((panels + across - 1) / across) * kPanelHeight, across * kPanelWidth, CV_8UC3, kPaper);
  for (int panel = 0; panel < panels; ++panel) {
    std::vector<cv::Point2d> points;
    for (const std::vector<double>& row : rows_)
      if (std::isfinite(row[static_cast<std::size_t>(panel) + 1]))
        points.emplace_back(row[0], row[static_cast<std::size_t>(panel) + 1]);
    if (points.empty()) continue;
    const cv::Rect place((panel % across) * kPanelWidth, (panel / across) * kPanelHeight, kPanelWidth,
                         kPanelHeight);
    draw_panel(drawing, place, columns_[static_cast<std::size_t>(panel) + 1], points);
  }
  std::vector<unsigned char> png;
  cv::imencode(".png", drawing, png);
  return write_file_atomically(picture, {reinterpret_cast<const char*>(png.data()), png.size()});
}

}  // namespace posecoach
