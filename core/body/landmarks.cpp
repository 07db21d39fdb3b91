#include "core/body/landmarks.h"

namespace posecoach {
namespace {

constexpr std::array<std::string_view, kLandmarkCount> kLandmarkNames = {
    "nose",        "left_eye_inner",  "left_eye",        "left_eye_outer", "right_eye_inner",
    "right_eye",   "right_eye_outer", "left_ear",        "right_ear",      "mouth_left",
    "mouth_right", "left_shoulder",   "right_shoulder",  "left_elbow",     "right_elbow",
    "left_wrist",  "right_wrist",     "left_pinky",      "right_pinky",    "left_index",
    "right_index", "left_thumb",      "right_thumb",     "left_hip",       "right_hip",
    "left_knee",   "right_knee",      "left_ankle",      "right_ankle",    "left_heel",
    "right_heel",  "left_foot_index", "right_foot_index"};

}  // namespace

std::string_view to_string(Landmark landmark) {
  return kLandmarkNames[static_cast<std::size_t>(landmark)];
}

Landmark mirrored(Landmark landmark) {
  const auto i = static_cast<unsigned>(landmark);
  if (i == 0) return landmark;
  if (i <= 6) return static_cast<Landmark>(i <= 3 ? i + 3 : i - 3);  // eyes come in threes
  return static_cast<Landmark>(i % 2 == 1 ? i + 1 : i - 1);          // all others in left-right pairs
}

}  // namespace posecoach
