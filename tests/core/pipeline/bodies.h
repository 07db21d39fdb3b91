// Webcam bodies of unlike proportions.
#pragma once

#include <initializer_list>
#include <utility>

#include "core/body/landmark_body.h"
#include "tests/core/retarget/motions.h"

namespace posecoach {

inline Skeleton body_with(double size, double arms, double legs) {
  const Skeleton plain = test_landmark_body(size);
  LandmarkBodyLengths lengths{};
  for (int joint = 0; joint < plain.size(); ++joint)
    lengths[static_cast<std::size_t>(joint)] = plain.bone_length(joint);
  lengths[0] = 0;
  for (const auto& [landmark, factor] :
       {std::pair{Landmark::LeftElbow, arms}, std::pair{Landmark::LeftWrist, arms},
        std::pair{Landmark::LeftKnee, legs}, std::pair{Landmark::LeftAnkle, legs}})
    for (const Landmark side : {landmark, mirrored(landmark)})
      lengths[static_cast<std::size_t>(landmark_joint(side))] *= factor;
  return make_landmark_body(lengths);
}
inline Skeleton tall_body() {
  return body_with(1.1, 0.9, 1.2);
}
inline Skeleton small_body() {
  return body_with(0.95, 1.15, 0.9);
}

}  // namespace posecoach
