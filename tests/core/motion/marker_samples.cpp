#include "marker_samples.h"

#include "core/body/standard_body.h"

namespace posecoach::samples {

using enum HumanoidJoint;

Motion moving_person(int frames) {
  const Skeleton body = make_standard_body();
  std::vector<MediaTime> times;
  std::vector<Vec3> roots;
  std::vector<Quat> rotations;
  for (int f = 0; f < frames; ++f) {
    const double phase = f * 0.05;
    times.push_back(media_time_from_seconds(f / 100.0));
    roots.emplace_back(0.1 * std::sin(phase), 0.95, 0.2 + 0.01 * f);
    for (int j = 0; j < body.size(); ++j) {
      const auto role = body.joint(j).role;
      Quat turn(1, 0, 0, 0);
      if (role == Pelvis) turn = glm::angleAxis(phase, Vec3(0, 1, 0));
      if (role == Spine) turn = glm::angleAxis(0.5, Vec3(1, 0, 0));
      if (role == LeftShoulder || role == RightShoulder)
        turn = glm::angleAxis(std::sin(phase), Vec3(0, 0.6, 0.8));
      if (role == LeftElbow) turn = glm::angleAxis(0.4 + 0.3 * std::sin(2 * phase), Vec3(0, 1, 0));
      if (role == LeftKnee || role == RightKnee) turn = glm::angleAxis(0.3, Vec3(1, 0, 0));
      rotations.push_back(turn);
    }
  }
  return Motion::from_rotations(body, times, roots, rotations).value();
}

MarkerTrack markers_of(const Motion& motion, const std::vector<LabelledJoint>& labels) {
  MarkerTrack track;
  track.metres_per_unit = 1;
  track.times.assign(motion.times().begin(), motion.times().end());
  for (const LabelledJoint& labelled : labels) track.labels.push_back(labelled.label);
  for (int f = 0; f < motion.frame_count(); ++f)
    for (const LabelledJoint& labelled : labels)
      track.positions.push_back(motion.position(f, motion.skeleton().find(labelled.role)));
  track.seen.assign(track.positions.size(), 1);
  return track;
}

std::vector<LabelledJoint> blazepose_labels() {
  return {{"left_shoulder", LeftShoulder}, {"right_shoulder", RightShoulder}, {"left_elbow", LeftElbow},
          {"right_elbow", RightElbow},     {"left_wrist", LeftWrist},         {"right_wrist", RightWrist},
          {"left_hip", LeftHip},           {"right_hip", RightHip},           {"left_knee", LeftKnee},
          {"right_knee", RightKnee},       {"left_ankle", LeftAnkle},         {"right_ankle", RightAnkle},
          {"left_foot_index", LeftToe},    {"right_foot_index", RightToe}};
}

std::vector<LabelledJoint> openpose_labels() {
  return {{"Neck", Neck},         {"RShoulder", RightShoulder}, {"RElbow", RightElbow},
          {"RWrist", RightWrist}, {"LShoulder", LeftShoulder},  {"LElbow", LeftElbow},
          {"LWrist", LeftWrist},  {"midHip", Pelvis},           {"RHip", RightHip},
          {"RKnee", RightKnee},   {"RAnkle", RightAnkle},       {"LHip", LeftHip},
          {"LKnee", LeftKnee},    {"LAnkle", LeftAnkle},        {"LBigToe", LeftToe},
          {"RBigToe", RightToe}};
}

}  // namespace posecoach::samples
