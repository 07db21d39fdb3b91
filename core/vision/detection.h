// From the detector network's numbers to people: anchors, decoding, merging of overlapping answers.
// Everything is in the coordinates of the network's square input, [0, 1], origin top left.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/math.h"

namespace posecoach {

struct Detection {
  double score = 0;  // in [0, 1]
  Vec2 low;          // corners of the box around the head
  Vec2 high;
  // Centre of the hips; a point on the circle around the whole body, above the head of an upright person; the
  // same two for the upper body.
  std::array<Vec2, 4> points;
};

inline constexpr int kDetectorInputSize = 224;  // pixels, a square
inline constexpr std::size_t kAnchorCount = 2254;
inline constexpr std::size_t kBoxNumbers = 12;  // of one anchor: box centre and size, four points

// Centres of the cells at strides 8, 16 and 32 of a 224-pixel square: two anchors a cell, six at the last.
std::vector<Vec2> make_anchors();

// `boxes` holds kBoxNumbers, `scores` one raw number an anchor. Only detections with a score of at least one
// half are kept.
std::vector<Detection> decode_detections(std::span<const float> boxes, std::span<const float> scores,
                                         std::span<const Vec2> anchors);

// Intersection over union of the two boxes.
double overlap(const Detection& a, const Detection& b);

// Non-maximum suppression with weights: the best detection becomes the mean, weighted by score, of all that
// overlap it by more than 0.3 (it keeps its own score); and so on with the rest. Best first.
std::vector<Detection> merge_overlapping(std::vector<Detection> detections);

}  // namespace posecoach
