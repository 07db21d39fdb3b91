// lift() while it happens: the student in the world, frame by frame, from what was seen so far. Where the
// camera stands, how it is tilted and where the floor is follow from the last seconds in which he stood; a
// swing does not move them.
#pragma once

#include <array>
#include <deque>
#include <optional>

#include "core/body/landmark_body.h"
#include "core/image/camera.h"
#include "core/pipeline/camera_fit.h"
#include "core/pipeline/lift.h"

namespace posecoach {

struct LiveStudent {
  // Joints of the webcam body; world as in LiftedStudent, its origin where he stood first.
  std::array<Vec3, kLandmarkBodyJointCount> positions;
  std::array<double, kLandmarkBodyJointCount> confidence{};
  PinholeCamera camera;
  CameraSide side;
};

class LiveLift {
 public:
  // What fixes his size: a measured body, else his stature, else the pose model's metres.
  void set_size(std::optional<Skeleton> body, std::optional<double> height_m);

  // Nothing while nobody is seen, or where the joints make no body before a camera.
  std::optional<LiveStudent> step(MediaTime time, const std::optional<SeenPerson>& person, int width_px,
                                  int height_px);

  // The joints of the last step in the camera's axes, metres, for measuring; nothing when it saw nobody.
  const std::optional<WorldKeypoints>& placed() const { return placed_; }
  // A body from the seconds seen so far, in the size that was set: before it is measured properly. Nothing
  // within the first second.
  std::optional<Skeleton> provisional_body() const;

  // Another camera: everything is forgotten but his size.
  void reset();

 private:
  struct Sighting {
    MediaTime time;
    SeenPerson person;
  };
  struct Ground {
    Vec3 up{0, -1, 0};  // camera axes
    Vec3 origin;        // on the floor, camera axes, the model's metres
  };

  double smooth_depth(MediaTime time, double depth);
  bool is_standing(MediaTime time, const SeenPerson& person);
  void remember(MediaTime time, const SeenPerson& person);
  void fit_camera(int width_px, int height_px);
  void fit_ground();
  std::vector<WorldKeypoints> placed_window() const;
  double scale() const;
  CameraSide side_of(const LiveStudent& student);

  std::optional<Skeleton> body_;
  std::optional<double> height_m_;
  std::optional<Intrinsics> intrinsics_;
  int width_px_ = 0, height_px_ = 0;
  int camera_fits_ = 0;
  std::optional<Ground> ground_;
  std::deque<Sighting> window_;  // standing, not closer together than a tenth of a second
  int new_in_window_ = 0;
  std::deque<Sighting> recent_;  // the last fifth of a second
  std::optional<MediaTime> moving_since_;
  std::optional<double> depth_;
  std::optional<WorldKeypoints> placed_;
  mutable std::optional<double> measured_size_;  // arms, legs and torso of the window, the model's metres
  mutable std::optional<double> measured_stature_;
  Vec3 facing_;
};

}  // namespace posecoach
