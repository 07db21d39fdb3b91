// Where the camera stands by a golfer at address: in front of him, on the target line, or beside one of them.
// The check before the swing and the analysis after it go by the same angles.
#pragma once

#include <cmath>
#include <string_view>

#include "core/base/math.h"
#include "core/coaching/viewpoint.h"
#include "core/motion/motion.h"

namespace posecoach {

// His front (face-on), along the target line (down the line), or neither.
enum class View { FaceOn, DownTheLine, Between };
std::string_view to_string(View view);  // "face-on", "down-the-line", "between"
Viewpoint viewpoint_of(View view);

// So far beside face-on or down the line a film is judged as one from there. Simulated golfers before a
// square camera were seen within 8 degrees of it, before one 20 degrees off at 11 or more.
inline constexpr double kSquare_deg = 10;
// Farther beside, it is neither.
inline constexpr double kAside_deg = 35;

struct CameraSide {
  View view = View::Between;
  // Degrees beside the nearer of face-on (positive towards his left) and down the line (positive towards his
  // front).
  double aside_deg = 0;

  bool is_square() const { return view != View::Between && std::abs(aside_deg) <= kSquare_deg; }
};

// From where what this camera films is judged: from an angle, unless it is square.
Viewpoint judged_from(const CameraSide& camera);

// `facing` is where the person's front points, `to_camera` where the camera stands from him; world axes, any
// length.
CameraSide camera_side(const Vec3& facing, const Vec3& to_camera);

// Where hips and shoulders face in one frame; level, unit length or zero.
Vec3 facing_in(const Motion& motion, int frame);

}  // namespace posecoach
