#include "core/body/mirror.h"

#include <array>
#include <string>
#include <utility>

#include "core/base/assert.h"

namespace posecoach {
namespace {

std::string with_sides_swapped(const std::string& name) {
  static constexpr std::array<std::pair<const char*, const char*>, 3> kSides = {
      {{"Left", "Right"}, {"left", "right"}, {"LEFT", "RIGHT"}}};
  for (const auto& [left, right] : kSides) {
    for (const auto& [from, to] : {std::pair(left, right), std::pair(right, left)}) {
      if (const auto at = name.find(from); at != std::string::npos)
        return std::string(name).replace(at, std::string(from).size(), to);
    }
  }
  if (name.size() > 1 && (name[0] == 'l' || name[0] == 'r')) {
    std::string other = name;
    other[0] = name[0] == 'l' ? 'r' : 'l';
    return other;
  }
  return name;
}

}  // namespace

std::vector<int> mirror_partners(const Skeleton& skeleton) {
  std::vector<int> partners;
  partners.reserve(static_cast<std::size_t>(skeleton.size()));
  for (int i = 0; i < skeleton.size(); ++i) {
    const Joint& joint = skeleton.joint(i);
    int partner =
        joint.role ? skeleton.find(mirrored(*joint.role)) : skeleton.find(with_sides_swapped(joint.name));
    partners.push_back(partner == kNoJoint ? i : partner);
  }
  return partners;
}

Skeleton mirrored(const Skeleton& skeleton) {
  const std::vector<int> partners = mirror_partners(skeleton);
  std::vector<Joint> joints(skeleton.joints().begin(), skeleton.joints().end());
  for (std::size_t i = 0; i < joints.size(); ++i)
    joints[i].offset = mirrored(skeleton.joint(partners[i]).offset);
  Result<Skeleton> made = Skeleton::make(std::move(joints));
  POSECOACH_ASSERT(made.has_value());
  return *std::move(made);
}

}  // namespace posecoach
