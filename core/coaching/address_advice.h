// Before the swing: how the student's posture at address differs from the coach's, as far as the camera can
// tell. For right-handers; mirror the tracks of left-handers first.
#pragma once

#include <string>
#include <vector>

#include "core/coaching/joint_track.h"
#include "core/coaching/viewpoint.h"

namespace posecoach {

// Both are single moments at address. What matters most first, at most two; empty where the postures agree.
std::vector<std::string> address_advice(const JointTrack& student, const JointTrack& coach, Viewpoint view);

}  // namespace posecoach
