// What lifting a whole film and lifting live have in common.
#pragma once

#include <array>

#include "core/body/skeleton.h"
#include "core/pipeline/camera_fit.h"

namespace posecoach {

// Each joint on its 2D joint's ray, as far away as the hips plus the model's relative depth; camera axes.
std::array<Vec3, kLandmarkCount> on_rays(const SeenPerson& person, double depth, const Intrinsics& camera);

// Summed length of arms, legs and torso: how large a body is, whatever single bones say.
double arms_legs_and_torso(const Skeleton& body);

}  // namespace posecoach
