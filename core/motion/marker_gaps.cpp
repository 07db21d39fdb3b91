#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "core/motion/marker_track.h"

namespace posecoach {
namespace {

using Triple = std::array<Vec3, 3>;

// Axes that turn and move with three points; nothing when they lie on a line.
struct LocalFrame {
  Vec3 origin;
  Mat3 axes;
};
std::optional<LocalFrame> frame_of(const Triple& p) {
  const Vec3 first = p[1] - p[0], second = p[2] - p[0];
  const Vec3 normal = glm::cross(first, second);
  if (glm::length(normal) <= 0.02 * glm::dot(first, first) || glm::length(first) <= 0) return std::nullopt;
  const Vec3 x = glm::normalize(first), z = glm::normalize(normal);
  return LocalFrame{p[0], Mat3(x, glm::cross(z, x), z)};
}

class GapFiller {
 public:
  explicit GapFiller(MarkerTrack& track) : track_(track) {}

  void fill(std::size_t marker) {
    marker_ = marker;
    const std::size_t frames = track_.times.size();
    std::size_t last_seen = frames;  // none
    for (std::size_t f = 0; f < frames;) {
      if (is_seen(f, marker)) {
        last_seen = f++;
        continue;
      }
      std::size_t next_seen = f;
      while (next_seen < frames && !is_seen(next_seen, marker)) ++next_seen;
      if (last_seen == frames && next_seen == frames) return;  // never seen at all
      if (companions_.empty()) rank_companions();
      for (; f < next_seen; ++f) track_.positions[track_.at(f, marker)] = estimate(f, last_seen, next_seen);
    }
  }

 private:
  bool is_seen(std::size_t frame, std::size_t marker) const {
    return track_.seen[track_.at(frame, marker)] != 0;
  }
  const Vec3& position(std::size_t frame, std::size_t marker) const {
    return track_.positions[track_.at(frame, marker)];
  }

  // The others by how much their distance to this marker varies, in a sample of the frames.
  void rank_companions() {
    constexpr std::size_t kSamples = 200;
    const std::size_t step = std::max<std::size_t>(1, track_.times.size() / kSamples);
    std::vector<std::pair<double, std::size_t>> ranked;
    for (std::size_t other = 0; other < track_.labels.size(); ++other) {
      if (other == marker_ || track_.labels[other].empty()) continue;
      double sum = 0, squares = 0;
      std::size_t count = 0;
      for (std::size_t f = 0; f < track_.times.size(); f += step) {
        if (!is_seen(f, marker_) || !is_seen(f, other)) continue;
        const double distance = glm::distance(position(f, marker_), position(f, other));
        sum += distance;
        squares += distance * distance;
        ++count;
      }
      if (count < 3) continue;
      const double mean = sum / static_cast<double>(count);
      // Near ones first among equals: what a turn is wrong by grows with the distance.
      constexpr double kSlackPerDistance = 0.05;
      const double variance = squares / static_cast<double>(count) - mean * mean;
      ranked.emplace_back(variance + std::pow(kSlackPerDistance * mean, 2), other);
    }
    std::sort(ranked.begin(), ranked.end());
    for (const auto& [slack, other] : ranked) companions_.push_back(other);
  }

  // Where the marker would be in `frame` if it had kept its place among its companions since `known`.
  std::optional<Vec3> carried(std::size_t known, std::size_t frame) const {
    constexpr std::size_t kMostTried = 8;
    std::vector<std::size_t> usable;
    for (const std::size_t other : companions_) {
      if (is_seen(known, other) && is_seen(frame, other)) usable.push_back(other);
      if (usable.size() == kMostTried) break;
    }
    for (std::size_t third = 2; third < usable.size(); ++third) {
      const std::array chosen = {usable[0], usable[1], usable[third]};
      Triple there, here;
      for (std::size_t i = 0; i < 3; ++i) {
        there[i] = position(known, chosen[i]);
        here[i] = position(frame, chosen[i]);
      }
      const auto from = frame_of(there), to = frame_of(here);
      if (from && to)
        return to->origin +
               to->axes * (glm::transpose(from->axes) * (position(known, marker_) - from->origin));
    }
    return std::nullopt;
  }

  Vec3 estimate(std::size_t frame, std::size_t last, std::size_t next) const {
    const std::size_t frames = track_.times.size();
    if (last == frames) return carried(next, frame).value_or(position(next, marker_));
    if (next == frames) return carried(last, frame).value_or(position(last, marker_));
    const double part = to_seconds(track_.times[frame] - track_.times[last]) /
                        to_seconds(track_.times[next] - track_.times[last]);
    const auto from_last = carried(last, frame), from_next = carried(next, frame);
    if (from_last && from_next) return *from_last * (1 - part) + *from_next * part;
    return position(last, marker_) * (1 - part) + position(next, marker_) * part;
  }

  MarkerTrack& track_;
  std::size_t marker_ = 0;
  std::vector<std::size_t> companions_;
};

}  // namespace

void fill_gaps(MarkerTrack& track, const std::vector<std::size_t>& markers) {
  for (const std::size_t marker : markers) GapFiller(track).fill(marker);
}

}  // namespace posecoach
