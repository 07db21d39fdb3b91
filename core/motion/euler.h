// Rotations as angles about axes in a given order, as BVH and ASF/AMC write them.
#pragma once

#include <array>
#include <span>

#include "core/base/math.h"

namespace posecoach {

enum class Axis : unsigned char { X, Y, Z };

Vec3 unit_vector(Axis axis);
Quat rotation_about(Axis axis, double radians);

// Three different axes; the rotation is R(order[0]) R(order[1]) R(order[2]), the last one acts first.
using EulerOrder = std::array<Axis, 3>;
bool is_euler_order(std::span<const Axis> axes);

// Radians, in the order's order. Of the two solutions, and of all full turns, the one nearest to `previous`,
// so that angles do not jump from frame to frame.
Vec3 euler_angles(const Quat& rotation, const EulerOrder& order, const Vec3& previous = Vec3(0));

}  // namespace posecoach
