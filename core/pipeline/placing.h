// What lifting a whole film and lifting live have in common.
#pragma once

#include <array>

#include "core/body/skeleton.h"
#include "core/pipeline/camera_fit.h"
#include "core/pipeline/lift.h"

namespace posecoach {

// Each joint on its 2D joint's ray, as far away as the hips plus the model's relative depth; camera axes.
std::array<Vec3, kLandmarkCount> on_rays(const SeenPerson& person, double depth, const Intrinsics& camera);

// Summed length of arms, legs and torso: how large a body is, whatever single bones say.
double arms_legs_and_torso(const Skeleton& body);

// Where the person's hips and shoulders face in one frame; level, unit length or zero.
Vec3 facing_in(const Motion& motion, int frame);

// `facing` is where the person's front points, `to_camera` where the camera stands from him; world axes, any
// length.
View view_from(const Vec3& facing, const Vec3& to_camera);
// How many degrees the camera stands beside the nearer of face-on and down-the-line.
double off_square_deg(const Vec3& facing, const Vec3& to_camera);
bool is_square(const Vec3& facing, const Vec3& to_camera);

}  // namespace posecoach
