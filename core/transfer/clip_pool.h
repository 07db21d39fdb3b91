// Recorded motions as clips of 3D poses, and pictures of synthetic people performing them.
#pragma once

#include <random>
#include <span>
#include <string>
#include <vector>

#include "core/transfer/synthetic_body.h"

namespace posecoach {

struct PoseClip {
  std::string name;
  std::vector<Pose3d> poses;
  std::array<double, kBone2dCount> lengths{};  // of the recorded person: medians over the clip
};

// Errors: those of poses_of.
Result<PoseClip> make_pose_clip(std::string name, const Motion& motion);

class PoseClipPool {
 public:
  // Asserts that there is at least one clip and that none is empty.
  explicit PoseClipPool(std::vector<PoseClip> clips);

  std::span<const PoseClip> clips() const { return clips_; }
  std::size_t frame_count() const;
  // Clips are drawn with the square root of their length as weight: a short golf swing must not drown in
  // dance.
  const PoseClip& random_clip(std::mt19937_64& random) const;

  // Every n-th clip of the pool, and the rest: a held-out part. Asserts n > 1 and at least n clips.
  static std::pair<std::vector<PoseClip>, std::vector<PoseClip>> split(std::vector<PoseClip> clips,
                                                                       std::size_t n);

 private:
  std::vector<PoseClip> clips_;
  mutable std::discrete_distribution<std::size_t> choice_;
};

// A pose of the first person as truth on the second, and the pictures that a transfer may look at.
struct TransferSample {
  std::vector<Pose2d> source;    // pictures of the first person; the first one is the pose
  std::vector<Pose2d> identity;  // pictures of the second person
  Pose2d truth;                  // the pose on the second person, same view
  Pose2d oracle;                 // 3D bone directions of the first with 3D lengths of the second, same view
  std::array<double, kBone2dCount> source_lengths{}, identity_lengths{};  // true ones, metres
  double source_stature_m = 0, stature_m = 0;  // of both people, as measure_bone_lengths means it
  bool hands_touch = false;                    // of the first person, in space
};

// 3D bone directions of a pose with other 3D lengths; the mid-hip at the origin.
Pose3d with_bone_lengths(const Pose3d& pose, const std::array<double, kBone2dCount>& lengths);
// The wrists are as near to each other as on a golf grip.
bool hands_touch(const Pose3d& pose, double stature_m);
// The stature of an average person whose bones are as long in sum.
double stature_from_lengths(const std::array<double, kBone2dCount>& lengths);

struct SampleOptions {
  SyntheticVariety variety = SyntheticVariety::Mixed;
  std::size_t source_pictures = 1;
  std::size_t identity_pictures = 1;
  bool one_source_view = true;  // a film from one camera; else each picture from anywhere
};
TransferSample random_sample(const PoseClipPool& pool, std::mt19937_64& random, const SampleOptions& options);

}  // namespace posecoach
