#pragma once

#include <cstddef>

namespace posecoach {

// Joints, frames and pixels are counted with int, so that differences may be negative; containers want
// std::size_t.
constexpr std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace posecoach
