// What is said about a metric: its definition in one line, and the range that good golfers are in, with its
// source. All in one place, to be read and translated together.
#pragma once

#include <optional>
#include <string_view>

namespace posecoach::text {

struct UsualRange {
  double low = 0, high = 0;
};

struct MetricText {
  std::string_view name, unit, definition;
  std::optional<UsualRange> usual = {};
  std::string_view source = {};  // of the range
};

// Asserts that there is one of this name.
const MetricText& metric(std::string_view name);

}  // namespace posecoach::text
