// Where a person stands before a pinhole camera, from his joints in 2D (pixels) and 3D (metres, the camera's
// axes, origin at his hips).
#pragma once

#include <span>
#include <vector>

#include "core/body/landmarks.h"

namespace posecoach {

struct Intrinsics {
  double focal_px = 1;
  Vec2 centre_px;
};

// The hips' place in camera axes that puts the 3D joints onto the 2D joints: linear least squares, then
// refined to least reprojection error; joints weigh their visibility. Nothing when it lies behind the camera.
std::optional<Vec3> fit_translation(const SeenPerson& person, const Intrinsics& camera);

// Weighted median distance in pixels between the projected 3D joints and the 2D joints over all frames.
double reprojection_error_px(std::span<const SeenPerson> people, std::span<const Vec3> translations,
                             const Intrinsics& camera);

// A focal length for the film. A phone's or webcam's usual view angle, unless another one explains the joints
// clearly better.
double estimate_focal_px(std::span<const SeenPerson> people, int width_px, int height_px);

}  // namespace posecoach
