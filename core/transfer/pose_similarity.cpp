#include "core/transfer/pose_similarity.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace posecoach {
namespace {

constexpr std::array<Joint2d, 5> kEnds = {Joint2d::Nose, Joint2d::LeftWrist, Joint2d::RightWrist,
                                          Joint2d::LeftAnkle, Joint2d::RightAnkle};
constexpr double kNoLength = 1e-9;

std::vector<Link> bone_links() {
  std::vector<Link> result;
  for (const Bone2d& bone : kBones2d) result.emplace_back(bone.parent, bone.child);
  return result;
}

std::vector<Link> end_links() {
  std::vector<Link> result;
  for (std::size_t i = 0; i < kEnds.size(); ++i)
    for (std::size_t j = i + 1; j < kEnds.size(); ++j) result.emplace_back(kEnds[i], kEnds[j]);
  return result;
}

std::vector<Link> bone_and_end_links() {
  std::vector<Link> result = bone_links();
  const std::vector<Link> ends = end_links();
  result.insert(result.end(), ends.begin(), ends.end());
  return result;
}

std::vector<Link> all_links() {
  std::vector<Link> result;
  for (std::size_t i = 0; i < kJoint2dCount; ++i)
    for (std::size_t j = i + 1; j < kJoint2dCount; ++j)
      result.emplace_back(static_cast<Joint2d>(i), static_cast<Joint2d>(j));
  return result;
}

// COCO's per-keypoint constants, in the order of Joint2d.
constexpr std::array<double, kJoint2dCount> kSigmas = {0.026, 0.079, 0.079, 0.079, 0.072, 0.072, 0.062, 0.062,
                                                       0.107, 0.107, 0.107, 0.087, 0.087, 0.089, 0.089};

}  // namespace

const std::vector<Link>& links(Links which) {
  static const std::vector<Link> bones = bone_links(), ends = bone_and_end_links(), all = all_links();
  switch (which) {
    case Links::Bones:
      return bones;
    case Links::BonesAndEnds:
      return ends;
    case Links::All:
      return all;
  }
  return all;
}

const std::vector<Link>& end_effector_links() {
  static const std::vector<Link> ends = end_links();
  return ends;
}

std::vector<Vec2> projection_directions(int count, double turned_radians) {
  POSECOACH_ASSERT(count > 0);
  std::vector<Vec2> directions;
  for (int i = 0; i < count; ++i) {
    const double angle = turned_radians + kPi * i / count;
    // A quarter turn's cosine is 6e-17, enough to flip a sign that should be zero.
    const auto exact = [](double value) { return std::abs(value) < 1e-15 ? 0.0 : value; };
    directions.emplace_back(exact(std::cos(angle)), exact(std::sin(angle)));
  }
  return directions;
}

LinkCount& LinkCount::operator+=(const LinkCount& other) {
  flipped += other.flipped;
  total += other.total;
  return *this;
}

LinkCount violations(const Pose2d& a, const Pose2d& b, std::span<const Link> links,
                     std::span<const Vec2> directions) {
  LinkCount count;
  for (const auto& [i, j] : links) {
    const Vec2 in_a = a[i] - a[j], in_b = b[i] - b[j];
    for (const Vec2& direction : directions) {
      if (glm::dot(in_a, direction) * glm::dot(in_b, direction) < 0) ++count.flipped;
      ++count.total;
    }
  }
  return count;
}

double mean_squared_angle(const Pose2d& a, const Pose2d& b, std::span<const Link> links) {
  double sum = 0;
  int counted = 0;
  for (const auto& [i, j] : links) {
    const Vec2 u = a[j] - a[i], v = b[j] - b[i];
    if (glm::length(u) < kNoLength || glm::length(v) < kNoLength) continue;
    const double angle = std::atan2(u.x * v.y - u.y * v.x, glm::dot(u, v));
    sum += angle * angle;
    ++counted;
  }
  return counted > 0 ? sum / counted : 0;
}

TransferError transfer_error(const Pose2d& result, const Pose2d& truth) {
  TransferError error;
  for (std::size_t b = 0; b < kBone2dCount; ++b) {
    const Bone2d& bone = kBones2d[b];
    const double difference = glm::length(result[bone.child] - result[bone.parent]) -
                              glm::length(truth[bone.child] - truth[bone.parent]);
    error.mse_lengths += difference * difference / double(kBone2dCount);
  }
  error.mse_angles = mean_squared_angle(result, truth, links(Links::Bones));
  const Pose2d a = centred(result), b = centred(truth);
  const Vec2 box = bounding_box(truth).size();
  // A person seen exactly edge-on, or a pose of one point, still has some extent.
  const double longest = std::max({box.x, box.y, 1e-6});
  const double area = std::max(box.x * box.y, 0.01 * longest * longest);
  for (std::size_t i = 0; i < kJoint2dCount; ++i) {
    const double distance = glm::length(a.positions[i] - b.positions[i]);
    const double k = 2 * kSigmas[i];
    error.mse_joints += distance / double(kJoint2dCount);
    error.oks_percent += 100 * std::exp(-distance * distance / (2 * area * k * k)) / double(kJoint2dCount);
  }
  return error;
}

}  // namespace posecoach
