// Colours as people pick them: sRGB, each channel in [0, 1], alpha not multiplied in.
#pragma once

namespace posecoach {

struct Colour {
  float red = 0, green = 0, blue = 0, alpha = 1;

  constexpr Colour with_alpha(float value) const { return {red, green, blue, value}; }
  constexpr bool operator==(const Colour&) const = default;
};

// 0xRRGGBB.
constexpr Colour colour_from_hex(unsigned hex) {
  return {static_cast<float>((hex >> 16) & 255U) / 255.0F, static_cast<float>((hex >> 8) & 255U) / 255.0F,
          static_cast<float>(hex & 255U) / 255.0F, 1.0F};
}

constexpr Colour mix(const Colour& a, const Colour& b, float t) {
  return {a.red + (b.red - a.red) * t, a.green + (b.green - a.green) * t, a.blue + (b.blue - a.blue) * t,
          a.alpha + (b.alpha - a.alpha) * t};
}

}  // namespace posecoach
