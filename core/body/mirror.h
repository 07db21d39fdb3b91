// Handedness: the mirror image of a body in the plane x = 0, with left and right exchanged.
#pragma once

#include <vector>

#include "core/body/skeleton.h"

namespace posecoach {

enum class Handedness { Right, Left };

inline Vec3 mirrored(const Vec3& v) {
  return {-v.x, v.y, v.z};
}
inline Quat mirrored(const Quat& q) {
  return {q.w, q.x, -q.y, -q.z};
}

// For each joint the joint that takes its place in the mirror: by role, else by swapping left and right in
// the name, else itself.
std::vector<int> mirror_partners(const Skeleton& skeleton);

// The mirrored body with the same joints in the same order: joint i gets the mirrored offset of its partner.
Skeleton mirrored(const Skeleton& skeleton);

}  // namespace posecoach
