// From what the pose stage saw in a film to the student in the world: one camera that stands still, gravity
// and floor from his stance, and his joints in metres such that the camera maps them onto the picture.
#pragma once

#include <optional>

#include "core/base/error.h"
#include "core/body/skeleton.h"
#include "core/image/camera.h"
#include "core/motion/motion.h"
#include "core/motion/pose_track.h"
#include "core/pipeline/camera_side.h"

namespace posecoach {

struct LiftOptions {
  std::optional<double> height_m;  // the student's stature; otherwise the pose model's metres count
  std::optional<Skeleton> body;    // measured before; a webcam body. Then `height_m` is not used
};

struct LiftedStudent {
  // World frame: +Y up, metres, the origin on the floor under the student, +Z from him towards the camera. On
  // the webcam body (core/body/landmark_body.h), positions only: bone lengths vary as the camera saw them.
  // Confidence is the landmarks' visibility; 0 in frames where he was not found (interpolated).
  Motion motion;
  Skeleton body;
  PinholeCamera camera;
  View view = View::Between;
  int first_frame =
      0;  // frame of the film that is frame 0 of `motion`; frames without him are cut at the ends
  double aside_deg = 0;  // as CameraSide has it
  // How well the pose model's own 3D joints, moved to their place, fit its 2D joints: median distance. The
  // joints of `motion` lie on the 2D joints' rays.
  double model_residual_px = 0;

  CameraSide side() const { return {view, aside_deg}; }
};

// Errors: NoPerson (nobody in any frame), Incomplete (seen in fewer than 3 frames), Malformed (a track
// without a picture size), InvalidArgument (a body that is no webcam body, a height out of range).
Result<LiftedStudent> lift(const PoseTrack& track, const LiftOptions& options = {});

}  // namespace posecoach
