// Pictures that carry their number, and films read back as numbers and times.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/image/frame.h"

namespace posecoach {

// A coloured slope with the bar code of `number`; at least 240 pixels each way.
Image numbered_picture(int width, int height, std::uint32_t number);
Frame numbered_frame(int width, int height, std::size_t number, double time_s);

struct NumberedFilm {
  std::vector<double> times_s;
  std::vector<std::optional<std::uint32_t>> numbers;
};

// Everything that can be decoded; empty where the film does not open.
NumberedFilm read_numbered_film(const std::filesystem::path& path);

}  // namespace posecoach
