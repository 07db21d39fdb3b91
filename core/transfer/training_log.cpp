#include "core/transfer/training_log.h"

#include <algorithm>
#include <cstdio>
#include <sstream>

#include "core/base/assert.h"
#include "core/base/file.h"
#include "core/image/curves.h"

namespace posecoach {
namespace {

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
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
  return write_curves(picture, {columns_, rows_});
}

}  // namespace posecoach
