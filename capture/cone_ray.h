// The geometry of the ray caster, in single precision: what a camera sees along a pixel's ray. Only plain
// arithmetic and square roots, whose results every machine has in common. Shared by the .cpp files that draw.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include <glm/geometric.hpp>

#include "capture/round_cone.h"

namespace posecoach::cone_ray {

using Float3 = glm::vec3;

// Results of the mathematics library differ in their last bits from machine to machine; rounded to a multiple
// of a small power of two they do not.
inline float snapped(double value) {
  return static_cast<float>(std::nearbyint(value * 1048576.0) / 1048576.0);
}
inline Float3 snapped(const Vec3& v) {
  return {snapped(v.x), snapped(v.y), snapped(v.z)};
}

struct View {
  Float3 right, down, forward, eye;  // the camera's axes in the world
  float focal_px, pixel_size, centre_x, centre_y;

  explicit View(const PinholeCamera& camera)
      : right(snapped(glm::transpose(camera.rotation_camera_from_world)[0])),
        down(snapped(glm::transpose(camera.rotation_camera_from_world)[1])),
        forward(snapped(glm::transpose(camera.rotation_camera_from_world)[2])),
        eye(snapped(camera.position())),
        focal_px(snapped(camera.focal_px)),
        pixel_size(1.0F / focal_px),
        centre_x(snapped(camera.centre_px.x)),
        centre_y(snapped(camera.centre_px.y)) {}

  // In the camera's axes, towards the image point, one metre deep: distances along it are depths.
  Float3 ray(float x_px, float y_px) const {
    return {(x_px - centre_x) * pixel_size, (y_px - centre_y) * pixel_size, 1.0F};
  }
  Float3 to_camera(const Float3& world) const {
    const Float3 v = world - eye;
    return {glm::dot(v, right), glm::dot(v, down), glm::dot(v, forward)};
  }
  Float3 direction_to_world(const Float3& v) const { return right * v.x + down * v.y + forward * v.z; }
};

inline constexpr float kFar = 1e9F;

// A cone in the camera's axes, where the eye is the origin, with what every ray needs worked out before.
//
// With p = t d - a for a ray d, h = p.w along the axis w: the side of the cone are the points whose distance
// from the axis, times c, is begin_radius - s h, where s is the sine of the half opening angle and c its
// cosine.
struct PreparedCone {
  enum class Part : std::uint8_t { Begin, Side, End };

  Float3 begin, end, axis;
  float length, begin_radius, end_radius;
  float sine, cosine;
  float side_constant, begin_constant, end_constant;
  float begin_along;  // -begin . axis
  SurfaceColour colour;

  PreparedCone(const RoundCone& cone, const View& view)
      : begin(view.to_camera(snapped(cone.begin))),
        end(view.to_camera(snapped(cone.end))),
        begin_radius(snapped(cone.begin_radius)),
        end_radius(snapped(cone.end_radius)),
        colour(cone.colour) {
    const Float3 along = end - begin;
    length = std::sqrt(glm::dot(along, along));
    if (length <= std::abs(begin_radius - end_radius) + 1e-6F) {  // one ball holds the other
      if (begin_radius < end_radius) begin = end;
      begin_radius = end_radius = std::max(begin_radius, end_radius);
      end = begin;
      length = 0;
      axis = Float3(0, 1, 0);
    } else {
      axis = along / length;
    }
    sine = length > 0 ? (begin_radius - end_radius) / length : 0.0F;
    cosine = std::sqrt(1.0F - sine * sine);
    begin_along = -glm::dot(begin, axis);
    begin_constant = glm::dot(begin, begin) - begin_radius * begin_radius;
    end_constant = glm::dot(end, end) - end_radius * end_radius;
    side_constant = cosine * cosine * glm::dot(begin, begin) - begin_along * begin_along +
                    2 * begin_radius * sine * begin_along - begin_radius * begin_radius;
  }

  // Where the ray enters the cone, if it does.
  struct Touch {
    float depth = 0;
    Part part = Part::Side;
    float along = 0;
  };
  std::optional<Touch> touch(const Float3& ray) const {
    const float squared = glm::dot(ray, ray);
    const float begin_on_ray = glm::dot(begin, ray);
    Touch nearest{kFar, Part::Side, 0};
    if (length > 0) {
      const float axis_on_ray = glm::dot(axis, ray);
      const float a = cosine * cosine * squared - axis_on_ray * axis_on_ray;
      const float b =
          begin_radius * sine * axis_on_ray - cosine * cosine * begin_on_ray - begin_along * axis_on_ray;
      const float discriminant = b * b - a * side_constant;
      if (discriminant < 0 && a > 0) return std::nullopt;  // misses even the endless cone
      if (discriminant >= 0 && std::abs(a) > 1e-9F) {
        const float root = std::sqrt(discriminant);
        const Touch first = side((-b - root) / a, axis_on_ray), second = side((-b + root) / a, axis_on_ray);
        // Where the ray enters the endless cone it enters this one, if it is there at all.
        if (a > 0 && first.depth < kFar) return first;
        nearest = first.depth < second.depth ? first : second;
      }
    }
    const Touch begin_ball{ball(squared, begin_on_ray, begin_constant), Part::Begin, 0};
    if (begin_ball.depth < nearest.depth) nearest = begin_ball;
    if (length > 0) {
      const Touch end_ball{ball(squared, glm::dot(end, ray), end_constant), Part::End, 0};
      if (end_ball.depth < nearest.depth) nearest = end_ball;
    }
    return nearest.depth < kFar ? std::optional(nearest) : std::nullopt;
  }

  Float3 normal(const Float3& ray, const Touch& touch) const {
    const Float3 point = ray * touch.depth;
    if (touch.part == Part::Begin) return (point - begin) / begin_radius;
    if (touch.part == Part::End) return (point - end) / end_radius;
    const Float3 radial = point - begin - axis * touch.along;
    const float radius = std::sqrt(glm::dot(radial, radial));
    return radius < 1e-9F ? axis * sine : radial * (cosine / radius) + axis * sine;
  }

 private:
  Touch side(float depth, float axis_on_ray) const {
    const float along = begin_along + depth * axis_on_ray;
    const bool is_here = depth > 0 && along >= begin_radius * sine && along <= length + end_radius * sine;
    return {is_here ? depth : kFar, Part::Side, along};
  }
  static float ball(float squared, float centre_on_ray, float constant) {
    const float discriminant = centre_on_ray * centre_on_ray - squared * constant;
    if (discriminant < 0 || centre_on_ray <= 0) return kFar;
    return (centre_on_ray - std::sqrt(discriminant)) / squared;
  }
};

// For the last step of a colour.
inline std::uint8_t to_byte(float value) {
  return static_cast<std::uint8_t>(std::clamp(value, 0.0F, 1.0F) * 255.0F + 0.5F);
}

}  // namespace posecoach::cone_ray
