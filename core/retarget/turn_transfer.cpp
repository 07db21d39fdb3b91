#include "core/retarget/turn_transfer.h"

#include <glm/geometric.hpp>

#include "core/base/index.h"
#include "core/body/forward_kinematics.h"
#include "core/body/two_bone_ik.h"
#include "core/retarget/rotation_recovery.h"

namespace posecoach {

TurnTransfer::TurnTransfer(const Motion& motion, const Skeleton& body, JointMapping mapping,
                           RotationSource rotations)
    : motion_(motion),
      body_(body),
      mapping_(std::move(mapping)),
      source_t_pose_(make_t_pose(motion.skeleton())),
      body_t_pose_(make_t_pose(body)),
      from_file_(motion.has_rotations() && rotations == RotationSource::FileFirst),
      source_turns_(index(motion.joint_count())),
      body_turns_(index(body.size())) {}

void TurnTransfer::read_turns(int frame) {
  if (!from_file_) {
    recover_turns(motion_.skeleton(), source_t_pose_, motion_.positions(frame), source_turns_);
    return;
  }
  global_rotations(motion_.skeleton(), motion_.rotations(frame), source_turns_);
  for (std::size_t j = 0; j < source_turns_.size(); ++j)
    source_turns_[j] = source_turns_[j] * glm::conjugate(source_t_pose_.rotations[j]);
}

void TurnTransfer::rotate(int frame, std::span<Quat> global) {
  read_turns(frame);
  for (int j = 0; j < body_.size(); ++j) {
    const MappedJoint& mapped = mapping_.joints[index(j)];
    const int parent = body_.joint(j).parent;
    Quat& turn = body_turns_[index(j)];
    if (mapped.source == kNoJoint) {
      turn = parent == kNoJoint || mapped.above_body ? Quat(1, 0, 0, 0) : body_turns_[index(parent)];
    } else {
      turn = source_turns_[index(mapped.source)];
      if (mapped.next.size() == 1) {
        // Where the coach has joints in between, his bones are followed as one: the chord over them.
        const int end = mapped.next_source[0];
        if (is_ancestor(motion_.skeleton(), mapped.source, end) &&
            motion_.skeleton().joint(end).parent != mapped.source) {
          const Vec3 rest =
              source_t_pose_.positions[index(end)] - source_t_pose_.positions[index(mapped.source)];
          const Vec3 now = motion_.position(frame, end) - motion_.position(frame, mapped.source);
          turn = swing_between(turn * rest, now) * turn;
        }
      }
    }
    global[index(j)] = turn * body_t_pose_.rotations[index(j)];
  }
}

void TurnTransfer::point(int frame, std::span<Quat> global) const {
  std::vector<Quat> before(global.begin(), global.end());
  for (int j = 0; j < body_.size(); ++j) {
    const MappedJoint& mapped = mapping_.joints[index(j)];
    if (mapped.source == kNoJoint) {
      // Moves as before with its parent.
      const int parent = body_.joint(j).parent;
      if (parent != kNoJoint)
        global[index(j)] = global[index(parent)] * glm::conjugate(before[index(parent)]) * before[index(j)];
      continue;
    }
    std::vector<DirectionPair> pairs;
    for (std::size_t k = 0; k < mapped.next.size(); ++k) {
      const Vec3 rest = body_t_pose_.positions[index(mapped.next[k])] - body_t_pose_.positions[index(j)];
      const Vec3 now =
          motion_.position(frame, mapped.next_source[k]) - motion_.position(frame, mapped.source);
      if (glm::length(rest) > 1e-9 && glm::length(now) > 1e-9)
        pairs.push_back({body_turns_[index(j)] * glm::normalize(rest), glm::normalize(now)});
    }
    if (pairs.empty()) continue;
    Quat correction = swing_between(pairs[0].from, pairs[0].to);
    if (pairs.size() > 1) {
      // The turn that is there already keeps the fit defined where all bones lie in one line.
      for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
        pairs.push_back({axis, axis, 1e-3});
      correction = best_rotation(pairs);
    }
    global[index(j)] = correction * global[index(j)];
  }
}

}  // namespace posecoach
