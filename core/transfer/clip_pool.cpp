#include "core/transfer/clip_pool.h"

#include <cmath>

#include "core/base/assert.h"
#include "core/base/median.h"

namespace posecoach {
namespace {

constexpr double kTouching = 0.09;  // wrist to wrist, as a fraction of stature: hands on one grip
constexpr double kPitchDeviation = 0.06;

double uniform(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
const Pose3d& random_pose(const PoseClip& clip, std::mt19937_64& random) {
  return clip.poses[std::uniform_int_distribution<std::size_t>(0, clip.poses.size() - 1)(random)];
}
CameraTurn random_view(std::mt19937_64& random) {
  return {uniform(random, -kPi, kPi), std::normal_distribution<double>(0, kPitchDeviation)(random)};
}

// One person, filmed; `flipped` people are the mirror images of the recorded ones.
Pose2d picture(const PoseClip& clip, const Pose3d& pose, const SyntheticBody& body, const CameraTurn& view,
               bool flipped) {
  const Pose2d seen = project(on_body(pose, clip.lengths, body), view);
  return flipped ? mirrored(seen) : seen;
}

}  // namespace

Result<PoseClip> make_pose_clip(std::string name, const Motion& motion) {
  Result<std::vector<Pose3d>> poses = poses_of(motion);
  if (!poses) return tl::unexpected(poses.error());
  PoseClip clip{std::move(name), *std::move(poses), {}};
  for (std::size_t b = 0; b < kBone2dCount; ++b) {
    std::vector<double> lengths;
    for (const Pose3d& pose : clip.poses) lengths.push_back(bone_lengths(pose)[b]);
    clip.lengths[b] = median(std::move(lengths));
  }
  return clip;
}

PoseClipPool::PoseClipPool(std::vector<PoseClip> clips) : clips_(std::move(clips)) {
  POSECOACH_ASSERT(!clips_.empty());
  std::vector<double> weights;
  for (const PoseClip& clip : clips_) {
    POSECOACH_ASSERT(!clip.poses.empty());
    weights.push_back(std::sqrt(double(clip.poses.size())));
  }
  choice_ = std::discrete_distribution<std::size_t>(weights.begin(), weights.end());
}

std::size_t PoseClipPool::frame_count() const {
  std::size_t count = 0;
  for (const PoseClip& clip : clips_) count += clip.poses.size();
  return count;
}

const PoseClip& PoseClipPool::random_clip(std::mt19937_64& random) const {
  return clips_[choice_(random)];
}

std::pair<std::vector<PoseClip>, std::vector<PoseClip>> PoseClipPool::split(std::vector<PoseClip> clips,
                                                                            std::size_t n) {
  POSECOACH_ASSERT(n > 1 && clips.size() >= n);
  std::pair<std::vector<PoseClip>, std::vector<PoseClip>> parts;
  for (std::size_t i = 0; i < clips.size(); ++i)
    (i % n == n - 1 ? parts.first : parts.second).push_back(std::move(clips[i]));
  return parts;
}

Pose3d with_bone_lengths(const Pose3d& pose, const std::array<double, kBone2dCount>& lengths) {
  Pose3d result;
  for (std::size_t b = 0; b < kBone2dCount; ++b) {
    const Vec3 bone = pose[kBones2d[b].child] - pose[kBones2d[b].parent];
    const double length = glm::length(bone);
    result[kBones2d[b].child] =
        result[kBones2d[b].parent] + (length > 0 ? bone * (lengths[b] / length) : bone);
  }
  return result;
}

bool hands_touch(const Pose3d& pose, double stature_m) {
  return glm::length(pose[Joint2d::LeftWrist] - pose[Joint2d::RightWrist]) < kTouching * stature_m;
}

double stature_from_lengths(const std::array<double, kBone2dCount>& lengths) {
  double sum = 0, average = 0;
  for (std::size_t b = 0; b < kBone2dCount; ++b) {
    sum += lengths[b];
    average += kAverageBoneLengths[b];
  }
  return sum / average;
}

TransferSample random_sample(const PoseClipPool& pool, std::mt19937_64& random,
                             const SampleOptions& options) {
  const SyntheticBody first = random_body(random, options.variety);
  const SyntheticBody second = random_body(random, options.variety);
  const PoseClip& clip = pool.random_clip(random);
  const Pose3d& pose = random_pose(clip, random);
  const CameraTurn view = random_view(random);
  const bool flipped = uniform(random, 0, 1) < 0.5;

  TransferSample sample;
  sample.truth = picture(clip, pose, second, view, flipped);
  sample.source.push_back(picture(clip, pose, first, view, flipped));
  while (sample.source.size() < options.source_pictures) {
    const CameraTurn other = options.one_source_view ? view : random_view(random);
    sample.source.push_back(picture(clip, random_pose(clip, random), first, other, flipped));
  }
  while (sample.identity.size() < options.identity_pictures) {
    const PoseClip& shown = pool.random_clip(random);
    sample.identity.push_back(
        picture(shown, random_pose(shown, random), second, random_view(random), uniform(random, 0, 1) < 0.5));
  }
  const auto length_on = [&](const SyntheticBody& body) {
    std::array<double, kBone2dCount> lengths = bone_lengths(on_body(pose, clip.lengths, body));
    for (std::size_t b = 0; b < kBone2dCount; ++b)
      if (b != 1) lengths[b] = body.length_m[b];  // the nose's place is only known on the body
    return lengths;
  };
  sample.source_lengths = length_on(first);
  sample.identity_lengths = length_on(second);
  sample.source_stature_m = stature_from_lengths(sample.source_lengths);
  sample.stature_m = stature_from_lengths(sample.identity_lengths);
  const Pose2d oracle =
      project(with_bone_lengths(on_body(pose, clip.lengths, first), sample.identity_lengths), view);
  sample.oracle = flipped ? mirrored(oracle) : oracle;
  sample.hands_touch = hands_touch(pose, stature_from_lengths(clip.lengths));
  return sample;
}

}  // namespace posecoach
