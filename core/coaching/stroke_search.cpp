#include "core/coaching/stroke_search.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/index.h"
#include "core/coaching/signal.h"

namespace posecoach {
namespace {

// A rise and fall of the hands smaller than this part of the torso is waggle, breath or putt.
constexpr double kBowProminence = 0.3;
constexpr double kBowSmoothing = 0.04 * kHandPathRate;
// Hands slower than this part of the stroke's largest speed are at rest, or slower than most of the film
// where they tremble (a webcam's hands do), but never above the second part.
constexpr double kRestSpeed = 0.06, kMostRestSpeed = 0.2;
constexpr double kTremble = 1.6, kQuietShare = 0.2;
constexpr double kRestSmoothing = 0.03 * kHandPathRate;
constexpr int kRestSamples = static_cast<int>(0.15 * kHandPathRate);
// A movement starts with the third power of time (no jump in acceleration). It is seen once it has covered
// this part of the way; where it began follows from two places further on.
constexpr double kVisible = 0.006;
constexpr double kNearStart = 0.02, kFarStart = 0.10;
constexpr double kNearRest = 0.001, kFarRest = 0.01;

std::vector<double> distance_from(const std::vector<Vec3>& positions, const Vec3& place) {
  std::vector<double> distance;
  distance.reserve(positions.size());
  for (const Vec3& p : positions) distance.push_back(glm::distance(p, place));
  return distance;
}

struct Rest {
  Vec3 place;
  double tremble = 0;  // root mean square distance from it
};

Rest rest_of(const std::vector<Vec3>& positions, int first, int last) {
  Rest rest;
  const double count = last - first + 1;
  for (int i = first; i <= last; ++i) rest.place += positions[index(i)] / count;
  double sum = 0;
  for (int i = first; i <= last; ++i)
    sum += glm::dot(positions[index(i)] - rest.place, positions[index(i)] - rest.place);
  rest.tremble = std::sqrt(sum / count);
  return rest;
}

double rest_speed(const std::vector<double>& speed, double largest) {
  std::vector<double> sorted = speed;
  const auto quiet =
      sorted.begin() + static_cast<std::ptrdiff_t>(kQuietShare * static_cast<double>(sorted.size()));
  std::nth_element(sorted.begin(), quiet, sorted.end());
  return std::clamp(kTremble * *quiet, kRestSpeed * largest, kMostRestSpeed * largest);
}

// The last time before `moving` that the hands rest long enough not to be a hesitation, at most kRestSamples
// of it; at the film's very start any rest will do.
std::optional<std::pair<int, int>> last_rest(const std::vector<double>& speed, int moving, double still) {
  for (int last = moving; last >= 0; --last) {
    if (speed[index(last)] > still) continue;
    int first = last;
    while (first > 0 && last - first < kRestSamples && speed[index(first - 1)] <= still) --first;
    if (first == 0 || last - first == kRestSamples) return std::pair(first, last);
    last = first;
  }
  return std::nullopt;
}

// Where a movement that has the distances c1 and c2 from rest at samples i1 and i2 began.
double extrapolated_start(double i1, double distance1, double i2, double distance2) {
  const double c1 = std::cbrt(distance1), c2 = std::cbrt(distance2);
  return c2 <= c1 ? i1 : i1 - c1 * (i2 - i1) / (c2 - c1);
}

}  // namespace

std::optional<SwingBow> find_bow(const HandPath& path) {
  const std::vector<double> height = smoothed(path.height, kBowSmoothing);
  const std::vector<Extreme> turns = extremes(height, kBowProminence * path.torso_m);
  std::optional<SwingBow> best;
  double best_speed = 0;
  for (std::size_t k = 0; k + 2 < turns.size(); ++k) {
    if (!turns[k].is_peak) continue;
    const SwingBow bow{turns[k].index, turns[k + 1].index, turns[k + 2].index};
    const double speed = path.speed[index(index_of_largest(path.speed, bow.top, bow.follow))];
    if (speed > best_speed) {
      best_speed = speed;
      best = bow;
    }
  }
  return best;
}

std::optional<StrokeStart> find_start(const HandPath& path, int moving, double largest_speed) {
  const std::vector<double> speed = smoothed(path.unweighted_speed, kRestSmoothing);
  const double still = rest_speed(speed, largest_speed);
  const auto rest = last_rest(speed, moving, still);
  if (!rest) return std::nullopt;
  const auto& [first, last] = *rest;
  const Rest before = rest_of(path.unweighted_hands, first, first + (last - first) / 2);
  const std::vector<double> distance = distance_from(path.unweighted_hands, before.place);
  const double way = distance[index(moving)];
  const auto passed = [&](double part) {
    return crossing(distance, moving, first, std::max(part * way, 3 * before.tremble));
  };
  const auto visible = passed(kVisible), near = passed(kNearStart), far = passed(kFarStart);
  StrokeStart start;
  start.rest_first = first;
  start.rest_last = first + (last - first) / 2;
  start.takeaway = visible.value_or(last);
  start.address = near && far ? extrapolated_start(*near, kNearStart, *far, kFarStart) : last;
  start.address = std::clamp(start.address, static_cast<double>(first), start.takeaway);
  return start;
}

std::vector<double> distance_from_rest(const HandPath& path, const StrokeStart& start) {
  const int first = start.rest_first, last = start.rest_last;
  const Vec3 left = rest_of(path.left_wrist, first, last).place,
             right = rest_of(path.right_wrist, first, last).place;
  double left_weight = 1e-3, right_weight = 1e-3;
  for (int i = first; i <= last; ++i) {
    left_weight += path.left_confidence[index(i)];
    right_weight += path.right_confidence[index(i)];
  }
  std::vector<double> distance;
  for (int i = 0; i < path.count(); ++i) {
    const Vec3 l = path.left_wrist[index(i)] - left, r = path.right_wrist[index(i)] - right;
    distance.push_back(std::sqrt((left_weight * glm::dot(l, l) + right_weight * glm::dot(r, r)) /
                                 (left_weight + right_weight)));
  }
  return distance;
}

double find_rest(const HandPath& path, int moving, double largest_speed) {
  const std::vector<double> speed = smoothed(path.speed, kRestSmoothing);
  const double still = rest_speed(speed, largest_speed);
  const int last = path.count() - 1;
  int rest = moving;
  while (rest <= last && speed[index(rest)] > still) ++rest;
  if (rest > last) return last;
  int end = rest;
  while (end < last && end - rest < 2 * kRestSamples && speed[index(end + 1)] < still) ++end;
  const Rest after = rest_of(path.hands, rest + (end - rest) / 2, end);
  const std::vector<double> distance = distance_from(path.hands, after.place);
  const double way = distance[index(moving)];
  const double near = std::max(kNearRest * way, 3 * after.tremble),
               far = std::min(near * kFarRest / kNearRest, std::max(3 * near, 0.03 * way));
  const auto near_at = crossing(distance, moving, end, near), far_at = crossing(distance, moving, end, far);
  if (!near_at || !far_at) return rest;
  return std::clamp(extrapolated_start(*near_at, near, *far_at, far), static_cast<double>(rest),
                    static_cast<double>(end));
}

}  // namespace posecoach
