// Made-up motions for the tests of retargeting.
#pragma once

#include <random>

#include "core/base/assert.h"
#include "core/body/forward_kinematics.h"
#include "core/body/landmark_body.h"
#include "core/motion/motion.h"

namespace posecoach {

inline std::vector<MediaTime> frame_times(int frames, double fps = 30) {
  std::vector<MediaTime> times;
  for (int f = 0; f < frames; ++f) times.push_back(media_time_from_seconds(f / fps));
  return times;
}

// Every joint turns about its own random axis by up to about 60 degrees, smoothly; the root wanders.
inline Motion random_motion(const Skeleton& skeleton, int frames, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto joints = static_cast<std::size_t>(skeleton.size());
  std::vector<Vec3> axes, speeds;
  for (std::size_t j = 0; j < joints; ++j) {
    axes.push_back({normal(random), normal(random), normal(random)});
    speeds.push_back({2 * normal(random), 3 * normal(random), normal(random)});
  }
  std::vector<Vec3> roots;
  std::vector<Quat> rotations;
  for (int f = 0; f < frames; ++f) {
    const double t = f / 30.0;
    roots.push_back(skeleton.joint(0).offset + Vec3(0.3 * std::sin(t), 0.05 * std::sin(3 * t), 0.2 * t));
    for (std::size_t j = 0; j < joints; ++j)
      rotations.push_back(glm::normalize(Quat(1, 0.35 * axes[j].x * std::sin(speeds[j].x * t + 1),
                                              0.35 * axes[j].y * std::sin(speeds[j].y * t + 2),
                                              0.35 * axes[j].z * std::sin(speeds[j].z * t + 3))));
  }
  return *Motion::from_rotations(skeleton, frame_times(frames), roots, rotations);
}

inline Motion standing_motion(const Skeleton& skeleton, int frames) {
  const std::vector<Quat> rest(static_cast<std::size_t>(frames) * static_cast<std::size_t>(skeleton.size()),
                               Quat(1, 0, 0, 0));
  return *Motion::from_rotations(
      skeleton, frame_times(frames),
      std::vector<Vec3>(static_cast<std::size_t>(frames), skeleton.joint(0).offset), rest);
}

inline Motion without_rotations(const Motion& motion) {
  std::vector<Vec3> positions;
  for (int f = 0; f < motion.frame_count(); ++f)
    positions.insert(positions.end(), motion.positions(f).begin(), motion.positions(f).end());
  return *Motion::from_positions(motion.skeleton(), {motion.times().begin(), motion.times().end()},
                                 positions);
}

inline Motion same_rotations(const Motion& motion, const Skeleton& body) {
  std::vector<Vec3> roots;
  std::vector<Quat> rotations;
  for (int f = 0; f < motion.frame_count(); ++f) {
    roots.push_back(motion.position(f, 0));
    rotations.insert(rotations.end(), motion.rotations(f).begin(), motion.rotations(f).end());
  }
  return *Motion::from_rotations(body, {motion.times().begin(), motion.times().end()}, roots, rotations);
}

inline Motion transformed(const Motion& motion, const Quat& yaw, const Vec3& shift) {
  std::vector<Vec3> roots, positions;
  std::vector<Quat> rotations;
  std::vector<double> confidence;
  for (int f = 0; f < motion.frame_count(); ++f) {
    roots.push_back(yaw * motion.position(f, 0) + shift);
    for (int j = 0; j < motion.joint_count(); ++j) {
      confidence.push_back(motion.confidence(f, j));
      positions.push_back(yaw * motion.position(f, j) + shift);
      if (motion.has_rotations()) {
        const Quat& local = motion.rotations(f)[static_cast<std::size_t>(j)];
        rotations.push_back(j == 0 ? yaw * local : local);
      }
    }
  }
  const std::vector<MediaTime> times(motion.times().begin(), motion.times().end());
  return motion.has_rotations() ? *Motion::from_rotations(motion.skeleton(), times, roots, rotations)
                                : *Motion::from_positions(motion.skeleton(), times, positions, confidence);
}

// The same positions over time, from a rig whose rest pose has the limb below `role` turned by `angle`.
inline Motion with_rest_pose_changed(const Motion& motion, HumanoidJoint role, const Vec3& axis,
                                     double angle) {
  const Skeleton& skeleton = motion.skeleton();
  const int limb = skeleton.find(role);
  const Quat turn = glm::angleAxis(angle, axis);
  std::vector<Joint> joints(skeleton.joints().begin(), skeleton.joints().end());
  std::vector<bool> turned(joints.size(), false);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const int parent = joints[j].parent;
    turned[j] =
        static_cast<int>(j) == limb || (parent != kNoJoint && turned[static_cast<std::size_t>(parent)]);
    if (parent != kNoJoint && turned[static_cast<std::size_t>(parent)])
      joints[j].offset = turn * joints[j].offset;
  }
  std::vector<Vec3> roots;
  std::vector<Quat> rotations, global(joints.size());
  for (int f = 0; f < motion.frame_count(); ++f) {
    roots.push_back(motion.position(f, 0));
    global_rotations(skeleton, motion.rotations(f), global);
    for (std::size_t j = 0; j < joints.size(); ++j)
      if (turned[j]) global[j] = global[j] * glm::conjugate(turn);
    std::vector<Quat> local(joints.size());
    local_rotations(skeleton, global, local);
    rotations.insert(rotations.end(), local.begin(), local.end());
  }
  return *Motion::from_rotations(*Skeleton::make(joints), {motion.times().begin(), motion.times().end()},
                                 roots, rotations);
}

// A webcam body of usual proportions, `size` times as large.
inline Skeleton test_landmark_body(double size) {
  LandmarkBodyLengths lengths{};
  lengths.fill(0.08 * size);
  lengths[0] = lengths[1] = lengths[3] = 0;
  lengths[2] = 0.50 * size;
  lengths[4] = 0.20 * size;
  const auto set = [&](Landmark left, double length) {
    lengths[static_cast<std::size_t>(landmark_joint(left))] = length * size;
    lengths[static_cast<std::size_t>(landmark_joint(mirrored(left)))] = length * size;
  };
  set(Landmark::LeftShoulder, 0.18);
  set(Landmark::LeftElbow, 0.29);
  set(Landmark::LeftWrist, 0.26);
  set(Landmark::LeftHip, 0.10);
  set(Landmark::LeftKnee, 0.43);
  set(Landmark::LeftAnkle, 0.42);
  set(Landmark::LeftFootIndex, 0.18);
  set(Landmark::LeftHeel, 0.09);
  return make_landmark_body(lengths);
}

}  // namespace posecoach
