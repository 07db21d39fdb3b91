// The 33 landmarks of the pose stage, in BlazePose's order, and what it sees in one picture.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/base/math.h"
#include "core/base/time.h"

namespace posecoach {

enum class Landmark : unsigned char {
  Nose,
  LeftEyeInner,
  LeftEye,
  LeftEyeOuter,
  RightEyeInner,
  RightEye,
  RightEyeOuter,
  LeftEar,
  RightEar,
  MouthLeft,
  MouthRight,
  LeftShoulder,
  RightShoulder,
  LeftElbow,
  RightElbow,
  LeftWrist,
  RightWrist,
  LeftPinky,
  RightPinky,
  LeftIndex,
  RightIndex,
  LeftThumb,
  RightThumb,
  LeftHip,
  RightHip,
  LeftKnee,
  RightKnee,
  LeftAnkle,
  RightAnkle,
  LeftHeel,
  RightHeel,
  LeftFootIndex,
  RightFootIndex,
};
inline constexpr std::size_t kLandmarkCount = 33;

// "nose", "left_eye_inner", ..., "right_foot_index".
std::string_view to_string(Landmark landmark);
Landmark mirrored(Landmark landmark);

// In the picture: pixels, origin top left, +Y down. `visibility` in [0, 1].
struct ImageKeypoint {
  Vec2 position_px;
  double visibility = 0;
};
// In the model's own frame: metres, origin between the hips, +Y down, +Z away from the camera.
struct WorldKeypoint {
  Vec3 position_m;
  double visibility = 0;
};

template <typename T>
struct LandmarkArray : std::array<T, kLandmarkCount> {
  T& operator[](Landmark l) { return std::array<T, kLandmarkCount>::operator[](static_cast<std::size_t>(l)); }
  const T& operator[](Landmark l) const {
    return std::array<T, kLandmarkCount>::operator[](static_cast<std::size_t>(l));
  }
  using std::array<T, kLandmarkCount>::operator[];
};
using ImageKeypoints = LandmarkArray<ImageKeypoint>;
using WorldKeypoints = LandmarkArray<WorldKeypoint>;

struct SeenPerson {
  ImageKeypoints image;
  WorldKeypoints world;
};

// One frame's answer; no person is a value, not an error.
struct PoseObservation {
  std::size_t frame_index = 0;
  MediaTime time;
  std::optional<SeenPerson> person;
};

}  // namespace posecoach
