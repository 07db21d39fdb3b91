#include "core/vision/detection.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/vision/plain_layers.h"

namespace posecoach {
namespace {

constexpr double kLeastScore = 0.5;
constexpr double kLeastOverlap = 0.3;

Detection weighted_mean(std::span<const Detection> group) {
  Detection mean;
  double sum = 0;
  for (const Detection& one : group) {
    sum += one.score;
    mean.low += one.score * one.low;
    mean.high += one.score * one.high;
    for (std::size_t k = 0; k < mean.points.size(); ++k) mean.points[k] += one.score * one.points[k];
  }
  mean.low /= sum;
  mean.high /= sum;
  for (Vec2& point : mean.points) point /= sum;
  mean.score = group.front().score;
  return mean;
}

}  // namespace

std::vector<Vec2> make_anchors() {
  struct Grid {
    int cells;
    int anchors_per_cell;
  };
  std::vector<Vec2> anchors;
  anchors.reserve(kAnchorCount);
  for (const Grid grid : {Grid{28, 2}, Grid{14, 2}, Grid{7, 6}})
    for (int y = 0; y < grid.cells; ++y)
      for (int x = 0; x < grid.cells; ++x)
        anchors.insert(anchors.end(), static_cast<std::size_t>(grid.anchors_per_cell),
                       Vec2((x + 0.5) / grid.cells, (y + 0.5) / grid.cells));
  return anchors;
}

std::vector<Detection> decode_detections(std::span<const float> boxes, std::span<const float> scores,
                                         std::span<const Vec2> anchors) {
  POSECOACH_ASSERT(scores.size() == anchors.size() && boxes.size() == kBoxNumbers * anchors.size());
  std::vector<Detection> found;
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    const double score = logistic(std::clamp(static_cast<double>(scores[i]), -100.0, 100.0));
    if (!(score >= kLeastScore)) continue;
    const auto pair = [&](std::size_t k) {
      return Vec2(boxes[i * kBoxNumbers + k], boxes[i * kBoxNumbers + k + 1]) / double{kDetectorInputSize};
    };
    Detection detection;
    detection.score = score;
    const Vec2 centre = anchors[i] + pair(0);
    detection.low = centre - 0.5 * pair(2);
    detection.high = centre + 0.5 * pair(2);
    for (std::size_t k = 0; k < detection.points.size(); ++k)
      detection.points[k] = anchors[i] + pair(4 + 2 * k);
    found.push_back(detection);
  }
  return found;
}

double overlap(const Detection& a, const Detection& b) {
  const auto area = [](const Vec2& low, const Vec2& high) {
    return std::max(0.0, high.x - low.x) * std::max(0.0, high.y - low.y);
  };
  const double shared = area({std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
                             {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)});
  const double all = area(a.low, a.high) + area(b.low, b.high) - shared;
  return all > 0 ? shared / all : 0;
}

std::vector<Detection> merge_overlapping(std::vector<Detection> detections) {
  std::stable_sort(detections.begin(), detections.end(),
                   [](const Detection& a, const Detection& b) { return a.score > b.score; });
  std::vector<Detection> merged;
  std::span<Detection> rest(detections);
  while (!rest.empty()) {
    const Detection best = rest.front();
    // The best belongs to its own group even when its box is empty.
    const auto behind = std::stable_partition(rest.begin() + 1, rest.end(), [&](const Detection& other) {
      return overlap(best, other) > kLeastOverlap;
    });
    const auto group = static_cast<std::size_t>(behind - rest.begin());
    merged.push_back(weighted_mean(rest.first(group)));
    rest = rest.subspan(group);
  }
  return merged;
}

}  // namespace posecoach
