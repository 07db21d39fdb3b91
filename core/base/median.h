#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/base/assert.h"

namespace posecoach {

// The middle of at least one value; of an even number, the upper of the two in the middle.
template <typename T>
T median(std::vector<T> values) {
  POSECOACH_ASSERT(!values.empty());
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace posecoach
