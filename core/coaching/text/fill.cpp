#include "core/coaching/text/fill.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace posecoach::text {

std::string filled(std::string_view sentence, const Blanks& blanks) {
  std::string words;
  while (!sentence.empty()) {
    const std::size_t open = sentence.find('{');
    words += sentence.substr(0, open);
    if (open == std::string_view::npos) break;
    const std::size_t close = sentence.find('}', open);
    POSECOACH_ASSERT(close != std::string_view::npos);
    const std::string_view name = sentence.substr(open + 1, close - open - 1);
    const auto blank =
        std::find_if(blanks.begin(), blanks.end(), [name](const auto& b) { return b.first == name; });
    POSECOACH_ASSERT(blank != blanks.end());
    words += blank->second;
    sentence.remove_prefix(close + 1);
  }
  return words;
}

std::string number(double value, int digits) {
  return fmt::format("{:.{}f}", value, digits);
}

std::string centimetres(double metres) {
  return number(100 * std::abs(metres), 0) + " cm";
}

std::string degrees(double value) {
  return number(std::abs(value), 0) + "°";
}

std::string percent(double part) {
  return number(100 * std::abs(part), 0) + " %";
}

}  // namespace posecoach::text
