#include "core/body/body_measurement.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/index.h"

namespace posecoach {
namespace {

// Below this visibility a landmark is a guess of the model: it counts, but hardly.
constexpr double kGuessVisibility = 0.5;
constexpr double kGuessWeight = 0.02;
// Tragion height over stature, and the height of a skull's base (where rigs put "head"), after the same
// tables as the standard body.
constexpr double kEarHeightPerStature = 0.93;
constexpr double kHeadJointHeightPerStature = 0.87;
// Of two sides that seem to differ: from which part of its length on a bone lies across the view, how nearly
// as much of both has to be seen so, and how far the shorter one may span beyond its length.
constexpr double kAcross = 0.9, kSeenAlike = 0.7, kSpanOverLength = 1.1;

// Pairs of value and weight; at least one.
double weighted_quantile(std::vector<std::pair<double, double>> values, double share) {
  std::sort(values.begin(), values.end());
  double total = 0, below = 0;
  for (const auto& [value, weight] : values) total += weight;
  for (const auto& [value, weight] : values)
    if ((below += weight) >= share * total) return value;
  return values.back().first;
}

double trust(double visibility) {
  return visibility >= kGuessVisibility ? visibility : kGuessWeight * visibility;
}

std::vector<BoneSighting> sightings_of(int joint, int parent, std::span<const WorldKeypoints> frames) {
  std::vector<BoneSighting> sightings;
  sightings.reserve(frames.size());
  for (const WorldKeypoints& frame : frames) {
    std::array<Vec3, kLandmarkCount> points;
    std::array<double, kLandmarkCount> visibility{};
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
      points[i] = frame[i].position_m;
      visibility[i] = frame[i].visibility;
    }
    const auto positions = landmark_body_positions(points);
    const auto confidence = landmark_body_confidence(visibility);
    const Vec3 bone = positions[index(joint)] - positions[index(parent)];
    const double length = glm::length(bone);
    if (!std::isfinite(length) || length <= 0) continue;
    sightings.push_back({length, std::hypot(bone.x, bone.y),
                         trust(confidence[index(joint)]) * trust(confidence[index(parent)])});
  }
  return sightings;
}

Result<void> check_height(double height_m) {
  if (height_m >= 0.5 && height_m <= 2.6) return {};
  return fail(ErrorCode::InvalidArgument, "a height must lie between 0.5 and 2.6 metres");
}

}  // namespace

std::optional<BoneLength> measure_bone(std::span<const BoneSighting> sightings) {
  std::vector<std::pair<double, double>> lengths;
  for (const BoneSighting& sighting : sightings)
    if (sighting.weight > 0) lengths.emplace_back(sighting.length_m, sighting.weight);
  if (lengths.empty()) return std::nullopt;
  const double long_side = weighted_quantile(lengths, 0.75);
  lengths.clear();
  for (const BoneSighting& sighting : sightings) {
    // The eighth power: a bone turned 30 degrees out of the picture counts a third, one turned 60 degrees
    // nothing.
    const double across = long_side > 0 ? std::min(1.0, sighting.across_m / long_side) : 1.0;
    const double weight = sighting.weight * (std::pow(across, 8) + 1e-4);
    if (sighting.weight > 0) lengths.emplace_back(sighting.length_m, weight);
  }
  const double length = weighted_quantile(lengths, 0.5);
  for (auto& [value, weight] : lengths) value = std::abs(value - length);
  return BoneLength{length, 1.48 * weighted_quantile(std::move(lengths), 0.5)};
}

namespace {

// How much of what was seen showed the bone lying across the view.
double weight_across(std::span<const BoneSighting> sightings) {
  double total = 0;
  for (const BoneSighting& sighting : sightings)
    if (sighting.across_m >= kAcross * sighting.length_m) total += sighting.weight;
  return total;
}

// What the bone spans in the picture in the longest quarter of all looks, also of those that are hardly
// trusted: a bone is not shorter than it looks.
double span_across(std::span<const BoneSighting> sightings) {
  std::vector<std::pair<double, double>> spans;
  for (const BoneSighting& sighting : sightings) spans.emplace_back(sighting.across_m, 1);
  return weighted_quantile(std::move(spans), 0.75);
}

bool are_seen_alike(std::span<const BoneSighting> left, std::span<const BoneSighting> right) {
  const double one = weight_across(left), other = weight_across(right);
  return std::min(one, other) > kSeenAlike * std::max(one, other);
}

}  // namespace

std::optional<BonePair> measure_bone_pair(std::span<const BoneSighting> left,
                                          std::span<const BoneSighting> right) {
  const auto left_alone = measure_bone(left), right_alone = measure_bone(right);
  if (left_alone && right_alone) {
    const double difference = std::abs(left_alone->length_m - right_alone->length_m);
    const double mean = 0.5 * (left_alone->length_m + right_alone->length_m);
    const bool is_right_shorter = right_alone->length_m < left_alone->length_m;
    const double shorter_m = std::min(left_alone->length_m, right_alone->length_m);
    if (difference > 0.25 * mean && difference > 3 * std::max(left_alone->spread_m, right_alone->spread_m) &&
        are_seen_alike(left, right) &&
        span_across(is_right_shorter ? right : left) < kSpanOverLength * shorter_m)
      return BonePair{left_alone->length_m, right_alone->length_m};
  }
  std::vector<BoneSighting> both(left.begin(), left.end());
  both.insert(both.end(), right.begin(), right.end());
  const auto pooled = measure_bone(both);
  if (!pooled) return std::nullopt;
  return BonePair{pooled->length_m, pooled->length_m};
}

Result<Skeleton> measure_landmark_body(std::span<const WorldKeypoints> frames,
                                       const MeasuringOptions& options) {
  if (frames.empty()) return fail(ErrorCode::Incomplete, "a body cannot be measured without any frame");
  if (options.height_m)
    if (auto ok = check_height(*options.height_m); !ok) return tl::unexpected(ok.error());
  const auto joints = landmark_body_joints();
  LandmarkBodyLengths lengths{};
  for (std::size_t j = 1; j < joints.size(); ++j) {
    const LandmarkJoint& joint = joints[j];
    const int own = static_cast<int>(j);
    if (joint.role == HumanoidJoint::Spine || joint.role == HumanoidJoint::Neck) continue;
    const auto never_seen = [&] {
      return fail(ErrorCode::Incomplete, "the body cannot be measured: " + joint.name + " is never seen");
    };
    if (joint.twin == kNoJoint) {
      const auto length = measure_bone(sightings_of(own, joint.parent, frames));
      if (!length) return never_seen();
      lengths[j] = length->length_m;
    } else if (joint.twin > own) {
      const auto pair = measure_bone_pair(sightings_of(own, joint.parent, frames),
                                          sightings_of(joint.twin, joints[index(joint.twin)].parent, frames));
      if (!pair) return never_seen();
      lengths[j] = pair->left_m;
      lengths[index(joint.twin)] = pair->right_m;
    }
  }
  const Skeleton body = make_landmark_body(lengths);
  return options.height_m ? scaled_to_stature(body, *options.height_m) : Result<Skeleton>(body);
}

double stature(const Skeleton& skeleton) {
  const auto rest = skeleton.rest_positions();
  double lowest = rest[0].y;
  for (const Vec3& p : rest) lowest = std::min(lowest, p.y);
  const int head = skeleton.find(HumanoidJoint::Head);
  if (skeleton.has(HumanoidJoint::HeadTop) || head == kNoJoint) return skeleton.rest_height();
  const double head_height = rest[index(head)].y - lowest;
  return std::max(
      skeleton.rest_height(),
      head_height / (is_landmark_body(skeleton) ? kEarHeightPerStature : kHeadJointHeightPerStature));
}

Result<Skeleton> scaled_to_stature(const Skeleton& skeleton, double height_m) {
  if (auto ok = check_height(height_m); !ok) return tl::unexpected(ok.error());
  const double now = stature(skeleton);
  if (!(now > 0)) return fail(ErrorCode::Incomplete, "the body has no height to be scaled");
  return skeleton.scaled(height_m / now);
}

}  // namespace posecoach
