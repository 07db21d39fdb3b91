// Which way is up and where the floor is, from how a person stands: the centre of mass is over the feet,
// heels and toes are on a level floor, and cameras are held about level.
#pragma once

#include <span>
#include <vector>

#include "core/base/math.h"

namespace posecoach {

struct Stance {
  Mat3 world_from_camera{1.0};            // rotation: +Y up, +Z horizontally towards the camera
  Vec3 origin;                            // on the floor under the person, camera axes, metres
  std::vector<std::size_t> still_frames;  // where he stands at address, in order of time
};

// `positions` frame-major, joints of the webcam body, camera axes (+Y down, +Z away), metres; at least one
// frame. The frame rate tells moving from trembling.
Stance estimate_stance(std::span<const Vec3> positions, double frames_per_second = 30);

}  // namespace posecoach
