// The bundled swing as a perfect pose stage would see it, for tests of what follows the pose stage; and any
// other motion.
#pragma once

#include <random>

#include "core/body/landmark_body.h"
#include "core/image/camera.h"
#include "core/motion/bundled_motion.h"
#include "core/motion/pose_track.h"
#include "core/retarget/retarget.h"

namespace posecoach {

struct Filmed {
  PoseTrack track;
  Motion truth;  // webcam body, world
  PinholeCamera camera;
};

struct Noise {
  double image_px = 0;
  double world_m = 0;
  double depth_m = 0;
};

// What a perfect pose stage would see of a motion in a body, plus noise: 2D from the camera, 3D as
// BlazePose gives it, hip-centred in the camera's axes.
inline Filmed film(const Motion& played, const Skeleton& body, const Vec3& eye, double view_degrees,
                   const Noise& noise, int width = 1280, int height = 720) {
  const Motion truth = retarget(played, body)->motion;
  const PinholeCamera camera =
      make_camera_looking_at(eye, {0, 0.9, 0.2}, radians_from_degrees(view_degrees), width, height);
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  PoseTrack track{"synthetic", width, height, {}};
  for (int f = 0; f < truth.frame_count(); ++f) {
    SeenPerson person;
    const Vec3 hips = camera.camera_from_world(truth.position(f, 0));
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
      const Vec3 p = truth.position(f, static_cast<int>(i) + kLandmarkBodyDerivedJoints);
      person.image[i] = {*camera.project(p) + noise.image_px * Vec2(normal(random), normal(random)), 0.95};
      person.world[i] = {camera.camera_from_world(p) - hips +
                             Vec3(noise.world_m * normal(random), noise.world_m * normal(random),
                                  noise.depth_m * normal(random)),
                         0.95};
    }
    track.frames.push_back({static_cast<std::size_t>(f), truth.time(f), person});
  }
  return {std::move(track), truth, camera};
}

// The bundled swing at 30 frames a second.
inline Filmed film(const Skeleton& body, const Vec3& eye, double view_degrees, const Noise& noise,
                   int width = 1280, int height = 720) {
  return film(resample(*bundled_motion("swing"), 30), body, eye, view_degrees, noise, width, height);
}

}  // namespace posecoach
