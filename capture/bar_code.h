// A frame's number in its own picture: black and white cells in the top left corner that survive video
// compression and scaling, so that a recording can prove that it lost nothing.
#pragma once

#include <cstdint>
#include <optional>

#include "core/image/frame.h"

namespace posecoach {

inline constexpr std::uint32_t kLargestBarCode = (1U << 20) - 1;

// Writes `number` modulo 2^20 into the corner, in place. Pictures under 240 pixels in either direction are
// left alone.
void write_bar_code(Image& image, std::uint32_t number);

// Nothing when there is no bar code or when it is damaged.
std::optional<std::uint32_t> read_bar_code(const Image& image);

}  // namespace posecoach
