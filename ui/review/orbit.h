// Looking at bodies from any side: an angle around them, a height, a distance.
#pragma once

#include "core/image/camera.h"

namespace posecoach {

struct Orbit {
  double turn = 0;       // radians about the vertical, 0 is in front of the golfer, positive towards his left
  double rise = 0.1;     // radians above the horizon
  double closeness = 1;  // larger is nearer
  bool operator==(const Orbit&) const = default;
};

inline constexpr Orbit kFrontOrbit{0, 0.08, 1};
inline constexpr Orbit kSideOrbit{-1.5707963267948966, 0.08, 1};  // from the golfer's right, down the line
inline constexpr Orbit kTopOrbit{0, 1.5533, 1};

// After the pointer was dragged so far, in points; the wheel comes nearer.
Orbit dragged(Orbit orbit, const Vec2& by, double wheel);

// A step about the body, of the keyboard: positive to his left.
Orbit turned_by_step(Orbit orbit, int steps);

// A picture in which a body of this height, standing at `feet`, has room for its arms. `front` is the angle
// about +Y of the direction that the golfer faces, from +Z.
PinholeCamera orbit_camera(const Orbit& orbit, const Vec3& feet, double height_m, double front, int width_px,
                           int height_px);

}  // namespace posecoach
