#include "core/retarget/network/correction_frames.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/index.h"
#include "core/retarget/doubt.h"
#include "core/retarget/network/turn_clip.h"
#include "core/retarget/rotation_recovery.h"
#include "core/retarget/webcam_noise.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

// The nearest joint further up that has a role: bones are seen from there, whatever hangs in between.
int carrier_of(const Skeleton& skeleton, int joint) {
  int j = skeleton.joint(joint).parent;
  while (j != kNoJoint && !skeleton.joint(j).role) j = skeleton.joint(j).parent;
  return j;
}

}  // namespace

std::vector<Quat> recovered_turns(const Motion& motion) {
  const TPose t_pose = make_t_pose(motion.skeleton());
  const std::size_t joints = index(motion.joint_count());
  std::vector<Quat> turns(index(motion.frame_count()) * joints);
  for (int frame = 0; frame < motion.frame_count(); ++frame)
    recover_turns(motion.skeleton(), t_pose, motion.positions(frame),
                  std::span(turns).subspan(index(frame) * joints, joints));
  return turns;
}

Quat rotation_from_vector(const Vec3& vector) {
  const double angle = glm::length(vector);
  return angle < 1e-12 ? Quat(1, 0, 0, 0) : Quat(glm::angleAxis(angle, vector / angle));
}

Vec3 vector_from_rotation(const Quat& rotation) {
  const double side = rotation.w < 0 ? -1 : 1;
  const Vec3 sine = side * Vec3(rotation.x, rotation.y, rotation.z);
  const double length = glm::length(sine);
  return length < 1e-12 ? 2.0 * sine : sine * (2 * std::atan2(length, side * rotation.w) / length);
}

CorrectionFrames correction_frames(const Motion& raw) {
  const Skeleton& skeleton = raw.skeleton();
  const Motion smooth = smoothed_where_doubtful(raw);
  CorrectionFrames made;
  std::vector<Vec3> across;
  for (int frame = 0; frame < raw.frame_count(); ++frame) {
    const auto line = [&](HumanoidJoint left, HumanoidJoint right) {
      const Vec3 v =
          smooth.position(frame, skeleton.find(left)) - smooth.position(frame, skeleton.find(right));
      return glm::length(v) > 1e-9 ? glm::normalize(v) : v;
    };
    across.push_back(line(LeftHip, RightHip) + line(LeftShoulder, RightShoulder));
  }
  made.headings = smooth_headings(across);
  made.turns = recovered_turns(smooth);
  std::array<std::vector<Quat>, kSteadySmoothings_s.size()> steadier;
  for (std::size_t i = 0; i < steadier.size(); ++i)
    steadier[i] = recovered_turns(smoothed_where_doubtful(raw, kSteadySmoothings_s[i]));
  for (int j = 0; j < skeleton.size(); ++j) {
    int carrier = j;
    while (carrier != kNoJoint && !skeleton.joint(carrier).role) carrier = skeleton.joint(carrier).parent;
    made.driver.push_back(carrier == kNoJoint ? Pelvis : *skeleton.joint(carrier).role);
  }
  const TPose t_pose = make_t_pose(skeleton);
  made.values.reserve(index(raw.frame_count()) * kCorrectionValues);
  const auto add = [&](double value) { made.values.push_back(static_cast<float>(value)); };
  const std::size_t joints = index(skeleton.size());
  for (int frame = 0; frame < raw.frame_count(); ++frame) {
    const Quat facing = glm::angleAxis(-made.headings[index(frame)], Vec3(0, 1, 0));
    for (const HumanoidJoint role : kHumanoidJoints) {
      const int joint = skeleton.find(role);
      const int carrier = joint == kNoJoint ? kNoJoint : carrier_of(skeleton, joint);
      Vec3 bone(0);
      double sure = 0;
      if (carrier != kNoJoint) {
        const double length = glm::distance(t_pose.positions[index(joint)], t_pose.positions[index(carrier)]);
        if (length > 0.01) {
          bone = facing * (raw.position(frame, joint) - raw.position(frame, carrier)) / length;
          if (glm::length(bone) > 3) bone *= 3 / glm::length(bone);
          sure = std::min(raw.confidence(frame, joint), raw.confidence(frame, carrier));
        }
      }
      for (int i = 0; i < 3; ++i) add(bone[i]);
      add(sure);
      const Quat turn =
          joint == kNoJoint ? Quat(1, 0, 0, 0) : facing * made.turns[index(frame) * joints + index(joint)];
      const Mat3 axes = glm::mat3_cast(turn);
      for (int i = 0; i < 3; ++i) add(joint == kNoJoint ? 0 : axes[0][i]);
      for (int i = 0; i < 3; ++i) add(joint == kNoJoint ? 0 : axes[1][i]);
      for (const std::vector<Quat>& steady : steadier) {
        Vec3 vector(0);
        if (joint != kNoJoint) {
          const std::size_t at = index(frame) * joints + index(joint);
          vector = facing * vector_from_rotation(steady[at] * glm::conjugate(made.turns[at]));
        }
        for (int i = 0; i < 3; ++i) {
          add(vector[i]);
          made.steadier.push_back(static_cast<float>(vector[i]));
        }
      }
    }
    const Vec3 camera = facing * kTowardsCamera;
    add(camera.x);
    add(camera.z);
  }
  return made;
}

}  // namespace posecoach
