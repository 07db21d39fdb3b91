#include "core/body/measured_skeleton.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "core/base/assert.h"
#include "core/base/index.h"
#include "core/body/standard_body.h"

namespace posecoach {
namespace {

double weighted_median(std::vector<std::pair<double, double>> value_and_weight) {
  std::sort(value_and_weight.begin(), value_and_weight.end());
  double total = 0;
  for (const auto& [value, weight] : value_and_weight) total += weight;
  double below = 0;
  for (const auto& [value, weight] : value_and_weight)
    if ((below += weight) >= total / 2) return value;
  return value_and_weight.back().first;
}

// Nothing when the bone was never seen.
std::optional<double> measured_length(std::size_t joint, std::size_t parent, std::size_t joint_count,
                                      std::span<const Vec3> positions, std::span<const double> confidence) {
  std::vector<std::pair<double, double>> lengths;
  for (std::size_t first = 0; first < positions.size(); first += joint_count) {
    const double weight =
        confidence.empty() ? 1.0 : std::min(confidence[first + joint], confidence[first + parent]);
    const double length = glm::distance(positions[first + joint], positions[first + parent]);
    if (weight > 0 && std::isfinite(length)) lengths.emplace_back(length, weight);
  }
  if (lengths.empty()) return std::nullopt;
  return weighted_median(std::move(lengths));
}

Vec3 t_pose_direction(const Skeleton& standard, HumanoidJoint parent, HumanoidJoint child) {
  const auto rest = standard.rest_positions();
  const Vec3 way = rest[index(standard.find(child))] - rest[index(standard.find(parent))];
  const double length = glm::length(way);
  return length > 0 ? way / length : Vec3(0, 1, 0);
}

}  // namespace

Result<Skeleton> measure_skeleton(std::span<const MeasuredJoint> joints, std::span<const Vec3> positions,
                                  std::span<const double> confidence) {
  POSECOACH_ASSERT(confidence.empty() || confidence.size() == positions.size());
  if (joints.empty() || positions.empty())
    return fail(ErrorCode::Incomplete, "a body cannot be measured without any frame");
  POSECOACH_ASSERT(positions.size() % joints.size() == 0);

  std::vector<Joint> measured;
  for (const MeasuredJoint& joint : joints) measured.push_back({joint.name, joint.parent, {}, joint.role});
  if (const Result<Skeleton> tree = Skeleton::make(measured); !tree) return tree;

  std::vector<double> lengths(joints.size(), 0.0);
  for (std::size_t j = 1; j < joints.size(); ++j) {
    const auto length = measured_length(j, index(joints[j].parent), joints.size(), positions, confidence);
    if (!length)
      return fail(ErrorCode::Incomplete, "the bone from " + joints[index(joints[j].parent)].name + " to " +
                                             joints[j].name + " is never seen, so it cannot be measured");
    lengths[j] = *length;
  }
  const auto with_role = [&](HumanoidJoint role) {
    return std::find_if(joints.begin(), joints.end(), [&](const auto& j) { return j.role == role; });
  };
  const Skeleton standard = make_standard_body();
  for (std::size_t j = 1; j < joints.size(); ++j) {
    const HumanoidJoint parent_role = joints[index(joints[j].parent)].role;
    double length = lengths[j];
    const auto twin = with_role(mirrored(joints[j].role));
    if (twin != joints.end() && twin->parent != kNoJoint &&
        joints[index(twin->parent)].role == mirrored(parent_role))
      length = (length + lengths[static_cast<std::size_t>(twin - joints.begin())]) / 2;
    measured[j].offset = length * t_pose_direction(standard, parent_role, joints[j].role);
  }
  const Result<Skeleton> at_origin = Skeleton::make(measured);
  POSECOACH_ASSERT(at_origin.has_value());
  double lowest = 0;
  for (const Vec3& rest : at_origin->rest_positions()) lowest = std::min(lowest, rest.y);
  measured[0].offset = {0, -lowest, 0};
  return Skeleton::make(std::move(measured));
}

}  // namespace posecoach
