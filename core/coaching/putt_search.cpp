#include <algorithm>
#include <cmath>

#include "core/coaching/signal.h"
#include "core/coaching/stroke_search.h"
#include "core/coaching/text/refusal_text.h"

namespace posecoach {
namespace {

// A putter's hands move at least this far there and back, metres.
constexpr double kLeastStroke_m = 0.04;
constexpr double kTrembling_s = 0.06;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

Result<StrokeMoments> find_putt(const HandPath& path, const std::vector<double>& forward) {
  const double range =
      *std::max_element(forward.begin(), forward.end()) - *std::min_element(forward.begin(), forward.end());
  const std::vector<Extreme> turns = extremes(forward, std::max(kLeastStroke_m, 0.2 * range));
  // The stroke is the fastest way forward between two turning points.
  int top = -1, end = -1;
  double fastest = 0;
  for (std::size_t k = 0; k + 1 < turns.size(); ++k) {
    if (turns[k].is_peak) continue;
    const int from = turns[k].index, to = turns[k + 1].index;
    const double speed = path.speed[at(index_of_largest(path.speed, from, to))];
    if (speed > fastest) {
      fastest = speed;
      top = from;
      end = to;
    }
  }
  if (top < 0) return fail(ErrorCode::Incomplete, text::no_stroke_seen());
  // Going back from the top to where the hands are fastest on their way there.
  int before = top;
  for (const Extreme& turn : turns)
    if (turn.is_peak && turn.index < top) before = turn.index;
  if (before == top) before = 0;
  const int moving = index_of_largest(path.speed, before, top);
  // A putt starts across the line of sight or is not seen at all: depth would only tremble.
  HandPath seen = path;
  seen.unweighted_hands = path.hands;
  seen.unweighted_speed = path.speed;
  auto start = find_start(seen, moving, path.speed[at(moving)]);
  if (!start) {
    // A webcam's hands may tremble as fast as a putter moves: over a longer time they rest.
    seen.unweighted_hands = smoothed(path.hands, kTrembling_s * kHandPathRate);
    seen.unweighted_speed = speed_of(seen.unweighted_hands, kHandPathRate);
    start = find_start(seen, moving, path.speed[at(moving)]);
  }
  if (!start) return fail(ErrorCode::Incomplete, text::no_rest_before_the_stroke());
  const double address = value_at(forward, start->address);
  const auto impact = crossing(forward, top, end, address);
  if (!impact) return fail(ErrorCode::Incomplete, text::hands_do_not_come_back());
  const double rest = find_rest(path, index_of_largest(path.speed, static_cast<int>(*impact), end), fastest);
  StrokeMoments found;
  found.takeaway = start->takeaway;
  found.is_rest_seen = rest < path.count() - 1;
  found.moments = {{"address", start->address},
                   {"top", vertex_near(forward, top)},
                   {"impact", *impact},
                   {"end", std::max(rest, *impact + 1)}};
  return found;
}

}  // namespace posecoach
