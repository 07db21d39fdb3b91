// The vector types of the whole program: GLM values in double precision (geometry must be exact to 1e-9).
// Quaternions are w, x, y, z in the constructor: Quat(w, x, y, z). Default: zero vectors, identity rotation.
#pragma once

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <numbers>

namespace posecoach {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Vec4 = glm::dvec4;
using Mat3 = glm::dmat3;
using Mat4 = glm::dmat4;
using Quat = glm::dquat;

inline constexpr double kPi = std::numbers::pi;
constexpr double radians_from_degrees(double degrees) {
  return degrees * kPi / 180.0;
}
constexpr double degrees_from_radians(double radians) {
  return radians * 180.0 / kPi;
}

inline bool is_finite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
inline bool is_finite(const Quat& q) {
  return std::isfinite(q.w) && std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z);
}

}  // namespace posecoach
