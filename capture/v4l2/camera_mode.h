// What a camera can be asked for, and which of it to ask for.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace posecoach {

struct CameraMode {
  std::uint32_t pixel_format = 0;  // V4L2's four characters
  int width = 0;
  int height = 0;
  std::vector<double> frame_rates;  // a second, fastest first; empty when the driver does not tell
};

// "MJPG", "YUYV".
std::string pixel_format_name(std::uint32_t pixel_format);

// Zero: ours. We wish for 1280x720 and 60 pictures a second: enough for the pose, and a swing is quick.
struct CameraWish {
  int width = 0;
  int height = 0;
  double fps = 0;
  std::string format = {};  // as pixel_format_name() tells it; empty: ours
};

struct ChosenMode {
  std::uint32_t pixel_format = 0;
  int width = 0;
  int height = 0;
  double fps = 0;  // 0: the driver's own
};

// The mode nearest to the wish. A format that was asked for comes first, where there is one of it; then a
// size that was asked for, else a rate of 30; then the size, then the rate, then uncompressed pictures before
// MJPEG: so MJPEG is taken where raw pictures cannot reach the rate. Nothing when there are no modes.
std::optional<ChosenMode> choose_mode(std::span<const CameraMode> modes, const CameraWish& wish);

}  // namespace posecoach
