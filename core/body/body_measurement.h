// A student's body from what a camera saw of him over many frames: bone lengths that one bad frame, a bone
// pointing at the camera or a hidden arm does not spoil.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/body/landmark_body.h"

namespace posecoach {

// One look at a bone: how long it seemed, how long across the view (without its depth), and how far to trust
// it (0: not at all).
struct BoneSighting {
  double length_m = 0;
  double across_m = 0;
  double weight = 0;
};

struct BoneLength {
  double length_m = 0;
  double spread_m = 0;  // robust standard deviation (1.48 x the weighted median deviation)
};

// The weighted median over the looks that show the bone's length: a camera makes bones that point at it too
// short, so looks weigh the more the longer the bone is across the view. Nothing when no sighting has a
// weight.
std::optional<BoneLength> measure_bone(std::span<const BoneSighting> sightings);

struct BonePair {
  double left_m = 0, right_m = 0;
};
// One length for both sides, from the sightings of both, unless both were seen equally well across the view
// and differ by over 25 % and by more than three times what either spreads, and the shorter one never spans
// more: people are symmetric, what a camera sees of them is not, least of all of the arm behind the trunk. A
// side without any weight takes the other's. Nothing when neither side was seen.
std::optional<BonePair> measure_bone_pair(std::span<const BoneSighting> left,
                                          std::span<const BoneSighting> right);

struct MeasuringOptions {
  std::optional<double> height_m;  // stature; otherwise the pose model's metres count
};

// The webcam body (core/body/landmark_body.h) from joints in the camera's axes; only differences count, so
// the origin may be anywhere. A sighting weighs the product of its ends' visibilities. Errors: Incomplete (no
// frames, a bone never seen, named), InvalidArgument (a height out of 0.5 to 2.6 m).
Result<Skeleton> measure_landmark_body(std::span<const WorldKeypoints> frames,
                                       const MeasuringOptions& options = {});

// How tall the person is, metres: what a skeleton spans, and the part of the head above its highest joint
// where it has no top of the head.
double stature(const Skeleton& skeleton);

// The body scaled to a stature. Errors: InvalidArgument (out of 0.5 to 2.6 m).
Result<Skeleton> scaled_to_stature(const Skeleton& skeleton, double height_m);

}  // namespace posecoach
