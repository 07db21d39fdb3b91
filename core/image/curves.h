// Curves over a common x axis as a picture, one panel each: how a training went.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace posecoach {

struct CurveTable {
  std::vector<std::string> columns;  // the first is the x axis
  std::vector<std::vector<double>> rows;
};

// A header and rows of numbers. Rows that are not as long as the header or not numbers are left out.
CurveTable curves_from_csv(std::string_view csv);

// A PNG with a panel for every column after the first; numbers that are not finite leave gaps. A table
// without rows or curves writes nothing. Errors: those of write_file_atomically.
Result<void> write_curves(const std::filesystem::path& picture, const CurveTable& table);

}  // namespace posecoach
