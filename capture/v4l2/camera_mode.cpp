#include "capture/v4l2/camera_mode.h"

#include <linux/videodev2.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace posecoach {
namespace {

constexpr double kGoodRate = 30;  // below it a swing is hardly seen
constexpr CameraWish kOurs = {1280, 720, 60};

// How far a mode is from the wish, the most important first; smaller is better.
using Distance = std::array<double, 6>;

bool is_jpeg(std::uint32_t pixel_format) {
  return pixel_format == V4L2_PIX_FMT_MJPEG || pixel_format == V4L2_PIX_FMT_JPEG;
}

double size_distance(const CameraMode& mode, int width, int height) {
  const auto log_ratio = [](int a, int b) { return std::abs(std::log2(static_cast<double>(a) / b)); };
  return log_ratio(mode.width, width) + log_ratio(mode.height, height);
}

}  // namespace

std::string pixel_format_name(std::uint32_t pixel_format) {
  std::string name;
  for (int shift = 0; shift < 32; shift += 8) {
    const char letter = static_cast<char>(pixel_format >> shift & 0x7F);
    name += letter > ' ' && letter != 0x7F ? letter : ' ';
  }
  name.erase(name.find_last_not_of(' ') + 1);
  return name;
}

std::optional<ChosenMode> choose_mode(std::span<const CameraMode> modes, const CameraWish& wish) {
  const bool wants_size = wish.width > 0 || wish.height > 0;
  const int height = wish.height > 0 ? wish.height : wish.width > 0 ? wish.width * 9 / 16 : kOurs.height;
  const int width = wish.width > 0 ? wish.width : wish.height > 0 ? wish.height * 16 / 9 : kOurs.width;
  const double fps = wish.fps > 0 ? wish.fps : kOurs.fps;
  std::optional<ChosenMode> best;
  Distance least{};
  for (const CameraMode& mode : modes) {
    // A driver that does not tell is taken at the usual rate.
    const std::vector<double> rates = mode.frame_rates.empty() ? std::vector<double>{0} : mode.frame_rates;
    for (const double rate : rates) {
      const double assumed = rate > 0 ? rate : kGoodRate;
      // Drivers round: 29.97 is 30.
      const double shortfall = std::max(0.0, fps - assumed - 0.1);
      const double below_good = std::max(0.0, std::min(fps, kGoodRate) - assumed - 0.1);
      const double size = size_distance(mode, width, height);
      const double excess = std::max(0.0, assumed - fps);
      const double other_format =
          !wish.format.empty() && pixel_format_name(mode.pixel_format) != wish.format ? 1 : 0;
      const double raw_first = is_jpeg(mode.pixel_format) ? 1 : 0;
      const Distance distance = wants_size
                                    ? Distance{other_format, size, below_good, shortfall, excess, raw_first}
                                    : Distance{other_format, below_good, size, shortfall, excess, raw_first};
      if (best && !(distance < least)) continue;
      least = distance;
      best = ChosenMode{mode.pixel_format, mode.width, mode.height, rate};
    }
  }
  return best;
}

}  // namespace posecoach
