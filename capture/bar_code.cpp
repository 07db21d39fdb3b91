#include "capture/bar_code.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace posecoach {
namespace {

// Two rows: each begins with a black and a white cell that give the levels; then 20 bits of the number and 4
// of its check sum, all inside a white margin of one cell.
constexpr int kRows = 2, kColumns = 14, kDataBits = 20, kCheckBits = 4;
constexpr int kSmallestSide_px = 240;
using Cells = std::array<std::array<bool, kColumns>, kRows>;  // true is white

double cell_size_px(const Image& image) {
  return std::min(image.width, image.height) / 60.0;
}

// Never 0 for small numbers, so that an all black or all white corner is not a code.
std::uint32_t check_sum(std::uint32_t number) {
  std::uint32_t sum = 0x9;
  for (int shift = 0; shift < kDataBits; shift += 4) sum = (sum * 7 + ((number >> shift) & 0xFU) + 3) & 0xFU;
  return sum;
}

Cells cells_of(std::uint32_t number) {
  const std::uint32_t bits = number | check_sum(number) << kDataBits;
  Cells cells{};
  int bit = 0;
  for (auto& row : cells) {
    row[0] = false;
    row[1] = true;
    for (std::size_t column = 2; column < kColumns; ++column) row[column] = (bits >> bit++ & 1U) != 0;
  }
  return cells;
}

int edge_px(double cells, double size) {
  return static_cast<int>(std::lround(cells * size));
}

// Mean brightness of the middle of a cell, away from its neighbours' smear.
double level(const Image& image, int column, int row) {
  const double size = cell_size_px(image);
  const auto first = [&](int cell) { return static_cast<int>(std::floor((cell + 1.3) * size)); };
  const auto last = [&](int cell) { return static_cast<int>(std::ceil((cell + 1.7) * size)); };
  double sum = 0;
  int count = 0;
  for (int y = first(row); y < last(row); ++y)
    for (int x = first(column); x < last(column); ++x, ++count) {
      const std::uint8_t* pixel = image.pixel(x, y);
      sum += (pixel[0] + pixel[1] + pixel[2]) / 3.0;
    }
  return sum / count;
}

bool is_too_small(const Image& image) {
  return std::min(image.width, image.height) < kSmallestSide_px;
}

}  // namespace

void write_bar_code(Image& image, std::uint32_t number) {
  if (is_too_small(image)) return;
  const Cells cells = cells_of(number & kLargestBarCode);
  const double size = cell_size_px(image);
  const auto fill = [&](double left, double top, double right, double bottom, std::uint8_t value) {
    for (int y = edge_px(top, size); y < edge_px(bottom, size); ++y)
      std::fill(image.pixel(edge_px(left, size), y), image.pixel(edge_px(right, size) - 1, y) + 3, value);
  };
  constexpr std::uint8_t kWhite = 235, kBlack = 20;
  fill(0, 0, kColumns + 2, kRows + 2, kWhite);
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column)
      if (!cells[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)])
        fill(column + 1, row + 1, column + 2, row + 2, kBlack);
}

std::optional<std::uint32_t> read_bar_code(const Image& image) {
  if (image.empty() || is_too_small(image)) return std::nullopt;
  std::uint32_t bits = 0;
  int bit = 0;
  for (int row = 0; row < kRows; ++row) {
    const double black = level(image, 0, row), white = level(image, 1, row);
    if (white - black < 80) return std::nullopt;
    for (int column = 2; column < kColumns; ++column)
      bits |= (level(image, column, row) > 0.5 * (black + white) ? 1U : 0U) << bit++;
  }
  const std::uint32_t number = bits & kLargestBarCode;
  if (bits >> kDataBits != check_sum(number)) return std::nullopt;
  return number;
}

}  // namespace posecoach
