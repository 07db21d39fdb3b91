#include "core/coaching/body_axes.h"

#include <glm/geometric.hpp>

namespace posecoach {
namespace {

using enum HumanoidJoint;

Vec3 level_direction(const Vec3& v) {
  const Vec3 level(v.x, 0, v.z);
  const double length = glm::length(level);
  return length > 1e-6 ? level / length : Vec3(0);
}

}  // namespace

BodyAxes body_axes(const JointTrack& track, double begin_s, double end_s) {
  Vec3 left(0);
  const int first = track.nearest_frame(begin_s), last = std::max(first, track.nearest_frame(end_s));
  for (int frame = first; frame <= last; ++frame)
    for (const auto& [l, r] : {std::pair(LeftHip, RightHip), std::pair(LeftShoulder, RightShoulder),
                               std::pair(LeftAnkle, RightAnkle)})
      left += level_direction(track.position(frame, l) - track.position(frame, r));
  BodyAxes axes;
  axes.left = level_direction(left);
  if (axes.left == Vec3(0)) axes.left = Vec3(1, 0, 0);
  axes.front = glm::cross(axes.left, axes.up);
  return axes;
}

double yaw_between(const BodyAxes& from, const BodyAxes& to) {
  const double cross = from.front.z * to.front.x - from.front.x * to.front.z;
  return std::atan2(cross, from.front.x * to.front.x + from.front.z * to.front.z);
}

Vec3 turned(const Vec3& v, double yaw) {
  const double c = std::cos(yaw), s = std::sin(yaw);
  return {c * v.x + s * v.z, v.y, c * v.z - s * v.x};
}

Vec3 in_axes(const BodyAxes& axes, const Vec3& v) {
  return {glm::dot(axes.left, v), glm::dot(axes.up, v), glm::dot(axes.front, v)};
}

}  // namespace posecoach
