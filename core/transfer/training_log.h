// A training's log: one CSV line an entry, and the curves as a picture.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace posecoach {

class TransferTrainingLog {
 public:
  // `columns[0]` is the x axis of the curves.
  TransferTrainingLog(std::filesystem::path csv, std::vector<std::string> columns);
  // Lines of an earlier run up to x = `last` are kept; none when the file is missing or of other columns.
  Result<void> resume(double last);
  void add(std::vector<double> row);
  // Writes the CSV and `picture` with one panel a column. Errors: those of write_file_atomically.
  Result<void> write(const std::filesystem::path& picture) const;

 private:
  std::filesystem::path csv_;
  std::vector<std::string> columns_;
  std::vector<std::vector<double>> rows_;
};

}  // namespace posecoach
