// A body and motions to transfer, made up: no recorded data is needed.
#pragma once

#include <cmath>

#include "core/transfer/clip_pool.h"

namespace posecoach {

inline SyntheticBody average_body(double stature_m) {
  SyntheticBody body;
  for (std::size_t b = 0; b < kBone2dCount; ++b) body.length_m[b] = stature_m * kAverageBoneLengths[b];
  return body;
}

// Somebody waving arms and bending knees; `phase` makes motions differ.
inline PoseClip waving_clip(double phase, std::size_t frames = 60) {
  PoseClip clip;
  clip.name = "waving" + std::to_string(phase);
  for (std::size_t b = 0; b < kBone2dCount; ++b) clip.lengths[b] = 1.75 * kAverageBoneLengths[b];
  for (std::size_t t = 0; t < frames; ++t) {
    const double a = phase + 0.13 * double(t), swing = 0.9 * std::sin(a),
                 bend = 0.4 + 0.4 * std::sin(0.7 * a);
    Pose3d pose;
    pose[Joint2d::MidHip] = {0, 0.95, 0};
    for (std::size_t b = 0; b < kBone2dCount; ++b) {
      const double side = kBones2d[b].twin < b ? -1 : 1;
      Vec3 direction{0, -1, 0};
      switch (kBones2d[b].child) {
        case Joint2d::Neck:
        case Joint2d::Nose:
          direction = {0.1 * std::sin(a), 1, 0.15};
          break;
        case Joint2d::LeftShoulder:
        case Joint2d::RightShoulder:
        case Joint2d::LeftHip:
        case Joint2d::RightHip:
          direction = {side, 0, 0.2 * side * std::sin(a)};
          break;
        case Joint2d::LeftElbow:
        case Joint2d::RightElbow:
          direction = {side * std::cos(swing), std::sin(swing + side), 0.3};
          break;
        case Joint2d::LeftWrist:
        case Joint2d::RightWrist:
          direction = {side * std::cos(2 * swing), std::sin(2 * swing), 0.8};
          break;
        case Joint2d::LeftKnee:
        case Joint2d::RightKnee:
          direction = {0.1 * side, -1, bend};
          break;
        default:
          direction = {0, -1, -bend};
      }
      pose[kBones2d[b].child] = pose[kBones2d[b].parent] + glm::normalize(direction) * clip.lengths[b];
    }
    clip.poses.push_back(pose);
  }
  return clip;
}

inline std::vector<PoseClip> waving_clips(std::size_t count) {
  std::vector<PoseClip> clips;
  for (std::size_t i = 0; i < count; ++i) clips.push_back(waving_clip(1.7 * double(i)));
  return clips;
}

}  // namespace posecoach
