// A filmed motion as the correction network sees it, and its corrections put back. Per frame, turned so that
// the body faces +Z: the bones as seen in units of their true lengths, how sure their ends are, how geometry
// turned the joints, how steadier smoothing would turn them, and where the camera is. A correction turns
// canonical joints: part of the way to the steadier turns, and by small rotations of the network's own.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/motion/motion.h"
#include "core/retarget/network/body_layout.h"

namespace posecoach {

// Besides the usual smoothing; what shakes and wanders is mostly gone after these.
inline constexpr std::array kSteadySmoothings_s = {0.12, 0.3};
inline constexpr int kSteadyTurns = static_cast<int>(kSteadySmoothings_s.size());
inline constexpr int kCorrectionValues = static_cast<int>(kHumanoidJointCount) * (10 + 3 * kSteadyTurns) + 2;

struct CorrectionFrames {
  std::vector<float> values;          // frame-major, kCorrectionValues a frame
  std::vector<double> headings;       // radians, one a frame
  std::vector<Quat> turns;            // frame-major, one a joint of the skeleton: geometry's, global
  std::vector<HumanoidJoint> driver;  // one a joint: the canonical joint whose correction it takes
  // Rotation vectors from the turns to the steadier ones, facing +Z: frame-major, one a canonical joint and
  // smoothing. Part of `values` too.
  std::vector<float> steadier;
};

// At any frame rate; the network's is kNetworkFramesPerSecond.
CorrectionFrames correction_frames(const Motion& filmed);

// Geometry's turns of every joint in every frame, frame-major, global, away from the T-pose.
std::vector<Quat> recovered_turns(const Motion& motion);

// Rotation vector (axis times angle, at most half a turn) to rotation and back.
Quat rotation_from_vector(const Vec3& vector);
Vec3 vector_from_rotation(const Quat& rotation);

}  // namespace posecoach
