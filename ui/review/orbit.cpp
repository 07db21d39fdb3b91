#include "ui/review/orbit.h"

#include <algorithm>
#include <cmath>

namespace posecoach {
namespace {

constexpr double kRadiansAPoint = 0.009;
constexpr double kHighest = 1.5533, kLowest = -0.35;
constexpr double kViewAngle = 0.55;  // vertical, radians

}  // namespace

Orbit dragged(Orbit orbit, const Vec2& by, double wheel) {
  orbit.turn = std::remainder(orbit.turn - kRadiansAPoint * by.x, 2 * kPi);
  orbit.rise = std::clamp(orbit.rise + kRadiansAPoint * by.y, kLowest, kHighest);
  orbit.closeness = std::clamp(orbit.closeness * std::exp(0.1 * wheel), 0.4, 4.0);
  return orbit;
}

Orbit turned_by_step(Orbit orbit, int steps) {
  constexpr double kStep = kPi / 24;
  orbit.turn = std::remainder(orbit.turn + steps * kStep, 2 * kPi);
  return orbit;
}

PinholeCamera orbit_camera(const Orbit& orbit, const Vec3& feet, double height_m, double front, int width_px,
                           int height_px) {
  const double height = std::clamp(height_m, 0.5, 3.0);
  // Arms and club reach as far to the sides as the body is high.
  const double tall = 1.16 * height, wide = 1.02 * height;
  const double aspect = static_cast<double>(width_px) / std::max(1, height_px);
  const double half = std::tan(0.5 * kViewAngle);
  const double distance = std::max(0.5 * tall / half, 0.5 * wide / (half * aspect)) / orbit.closeness;
  const double angle = front + orbit.turn;
  const Vec3 target = feet + Vec3(0, 0.52 * height, 0);
  const Vec3 eye = target + distance * Vec3(std::sin(angle) * std::cos(orbit.rise), std::sin(orbit.rise),
                                            std::cos(angle) * std::cos(orbit.rise));
  return make_camera_looking_at(eye, target, kViewAngle, std::max(1, width_px), std::max(1, height_px));
}

}  // namespace posecoach
