// The methods `rotation` and `direction`: the coach's turns away from his T-pose, given to the student's
// T-pose.
#pragma once

#include <span>
#include <vector>

#include "core/retarget/joint_mapping.h"
#include "core/retarget/retarget.h"
#include "core/retarget/t_pose.h"

namespace posecoach {

// One coach and one body, prepared once and used frame by frame.
class TurnTransfer {
 public:
  // `motion` must outlive this object.
  TurnTransfer(const Motion& motion, const Skeleton& body, JointMapping mapping, RotationSource rotations);

  // Global rotations of the body's joints (from its rest pose) in this frame.
  void rotate(int frame, std::span<Quat> global);
  // After `rotate`: turns every bone onto the direction of the coach's bone; a joint that carries several
  // bones takes the best fit, since one rotation cannot please all.
  void point(int frame, std::span<Quat> global) const;

  const TPose& source_t_pose() const { return source_t_pose_; }
  const TPose& body_t_pose() const { return body_t_pose_; }

 private:
  void read_turns(int frame);

  const Motion& motion_;
  Skeleton body_;
  JointMapping mapping_;
  TPose source_t_pose_, body_t_pose_;
  bool from_file_;
  std::vector<Quat> source_turns_, body_turns_;
};

}  // namespace posecoach
