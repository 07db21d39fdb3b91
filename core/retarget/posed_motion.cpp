#include "core/retarget/posed_motion.h"

#include "core/base/assert.h"
#include "core/base/index.h"
#include "core/body/forward_kinematics.h"
#include "core/retarget/rotation_recovery.h"

namespace posecoach {

PosedMotion::PosedMotion(const Motion& motion)
    : skeleton_(motion.skeleton()), times_(motion.times().begin(), motion.times().end()) {
  const Motion posed = with_rotations(motion);
  const std::size_t joints = index(skeleton_.size());
  global_.resize(times_.size() * joints);
  positions_.reserve(global_.size());
  for (int f = 0; f < frame_count(); ++f) {
    roots_.push_back(posed.position(f, 0));
    global_rotations(skeleton_, posed.rotations(f), std::span(global_).subspan(index(f) * joints, joints));
    positions_.insert(positions_.end(), posed.positions(f).begin(), posed.positions(f).end());
  }
}

Motion PosedMotion::motion() const {
  const std::size_t joints = index(skeleton_.size());
  std::vector<Quat> local(global_.size());
  for (std::size_t first = 0; first < local.size(); first += joints)
    local_rotations(skeleton_, std::span(global_).subspan(first, joints),
                    std::span(local).subspan(first, joints));
  Result<Motion> made = Motion::from_rotations(skeleton_, times_, roots_, std::move(local));
  POSECOACH_ASSERT(made.has_value());
  return *std::move(made);
}

void PosedMotion::shift(int frame, const Vec3& by) {
  roots_[index(frame)] += by;
  update(frame);
}

void PosedMotion::turn(int frame, int joint, const Quat& turn, int except) {
  const std::size_t first = index(frame) * index(skeleton_.size());
  std::vector<bool> turned(index(skeleton_.size()), false);
  for (int j = joint; j < skeleton_.size(); ++j) {
    const int parent = skeleton_.joint(j).parent;
    if (j == except || (j != joint && (parent == kNoJoint || !turned[index(parent)]))) continue;
    turned[index(j)] = true;
    global_[first + index(j)] = glm::normalize(turn * global_[first + index(j)]);
  }
  update(frame);
}

void PosedMotion::update(int frame) {
  const std::size_t joints = index(skeleton_.size()), first = index(frame) * joints;
  joint_positions(skeleton_, roots_[index(frame)], std::span<const Quat>(global_).subspan(first, joints),
                  std::span(positions_).subspan(first, joints));
}

}  // namespace posecoach
