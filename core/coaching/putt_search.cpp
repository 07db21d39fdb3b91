#include <algorithm>
#include <cmath>

#include "core/base/index.h"
#include "core/coaching/signal.h"
#include "core/coaching/stroke_search.h"
#include "core/coaching/text/refusal_text.h"
#include "core/coaching/way_fit.h"

namespace posecoach {
namespace {

// A putter's hands move at least this far there and back, metres, and so many times as far as they tremble.
constexpr double kLeastStroke_m = 0.012, kLeastOverTremble = 5;
// A putter's hands stay low: higher than this part of the torso they swing.
constexpr double kMostRise = 0.6;
// Of all their way: a pose model lets hands go back less than they do.
constexpr double kLeastPart = 0.1;
// How long a rest is looked at, and the least of it.
constexpr double kRest_s = 0.4, kLeastRest_s = 0.1;
constexpr double kShortestWay_s = 0.2, kLongestWay_s = 3;
// What rests moves by less than this part of the way that follows.
constexpr double kMostAtRest = 0.25;
// Of the way back, on each side of impact.
constexpr double kPassing = 0.6;
// Of the way back, that the hands are beyond their rest when the putter is at the ball: they lead it there.
constexpr double kAhead = 0.1;
// A putt is told from a settling of the joints by how far it goes in this time, too.
constexpr double kQuick_s = 0.15;
// Of a way, where it is first seen.
constexpr double kVisibleTime = 0.1205;  // to_turn(kVisibleTime) == 0.01

int samples(double seconds) {
  return static_cast<int>(std::lround(seconds * kHandPathRate));
}

struct Spread {
  double mean = 0, deviation = 0;
};
Spread spread_of(const std::vector<double>& values, int first, int last) {
  Spread spread;
  const double count = last - first + 1;
  for (int i = first; i <= last; ++i) spread.mean += values[index(i)] / count;
  for (int i = first; i <= last; ++i)
    spread.deviation += (values[index(i)] - spread.mean) * (values[index(i)] - spread.mean) / count;
  spread.deviation = std::sqrt(spread.deviation);
  return spread;
}

// A rest and the way from or to it.
struct Fit {
  int rest_ends = 0;  // and the way begins, or the other way round
  Spread rest;
  double error = 0;  // mean square
};

// Where the rest ends from which the values go to their turn at `goal`.
std::optional<Fit> fit_start(const std::vector<double>& values, int earliest, int goal) {
  std::optional<Fit> best;
  const int from = std::max(earliest + samples(kLeastRest_s), goal - samples(kLongestWay_s));
  for (int start = from; start <= goal - samples(kShortestWay_s); ++start) {
    const int first = std::max(earliest, start - samples(kRest_s));
    Fit fit{start, spread_of(values, first, start), 0};
    double sum = fit.rest.deviation * fit.rest.deviation * (start - first + 1);
    for (int i = start + 1; i <= goal; ++i) {
      const double way = to_turn(static_cast<double>(i - start) / (goal - start));
      const double off = values[index(i)] - (fit.rest.mean + way * (values[index(goal)] - fit.rest.mean));
      sum += off * off;
    }
    fit.error = sum / (goal - first + 1);
    if (!best || fit.error < best->error) best = fit;
  }
  return best;
}

// Where the rest begins to which the values come from `fastest`: the second half of a way to rest.
std::optional<Fit> fit_end(const std::vector<double>& values, int fastest) {
  std::optional<Fit> best;
  const int last = static_cast<int>(values.size()) - 1;
  const int until = std::min(last - samples(kLeastRest_s), fastest + samples(kLongestWay_s / 2));
  for (int end = fastest + samples(kShortestWay_s / 2); end <= until; ++end) {
    const int rest_last = std::min(last, end + samples(kRest_s));
    Fit fit{end, spread_of(values, end, rest_last), 0};
    double sum = fit.rest.deviation * fit.rest.deviation * (rest_last - end + 1);
    for (int i = fastest; i < end; ++i) {
      const double way = 2 * to_rest(0.5 + 0.5 * (i - fastest) / (end - fastest)) - 1;
      const double off =
          values[index(i)] - (values[index(fastest)] + way * (fit.rest.mean - values[index(fastest)]));
      sum += off * off;
    }
    fit.error = sum / (rest_last - fastest + 1);
    if (!best || fit.error < best->error) best = fit;
  }
  return best;
}

// Where a line through the middle of the way forward passes `level`: joints that stick near it, as a pose
// model's do, move it less than they move the crossing itself.
std::optional<double> passing(const std::vector<double>& values, int top, int end, double level) {
  if (!crossing(values, top, end, level)) return std::nullopt;
  const double back = level - values[index(top)];
  const auto begins = crossing(values, top, end, level - kPassing * back),
             ends = crossing(values, top, end, level + kPassing * back);
  if (!begins || !ends) return crossing(values, top, end, level);
  double count = 0, sum_t = 0, sum_v = 0, sum_tt = 0, sum_tv = 0;
  for (int i = static_cast<int>(*begins); i <= static_cast<int>(*ends) + 1; ++i) {
    const double t = i - *begins, v = values[index(i)] - level;
    count += 1;
    sum_t += t;
    sum_v += v;
    sum_tt += t * t;
    sum_tv += t * v;
  }
  const double slope = (count * sum_tv - sum_t * sum_v) / (count * sum_tt - sum_t * sum_t);
  if (!(slope > 0)) return crossing(values, top, end, level);
  return std::clamp(*begins + (sum_t - sum_v / slope) / count, *begins, *ends);
}

// What the values do between neighbours that is no movement.
double tremble_of(const std::vector<double>& values) {
  const int step = samples(1.0 / 30);
  double sum = 0;
  int count = 0;
  for (int i = step; i + step < static_cast<int>(values.size()); ++i, ++count) {
    const double bend = values[index(i - step)] - 2 * values[index(i)] + values[index(i + step)];
    sum += bend * bend / 6;
  }
  return count > 0 ? std::sqrt(sum / count) : 0;
}

// The most that values rise within a short time, between two places.
double quickest_rise(const std::vector<double>& values, int from, int to) {
  const int step = std::min(samples(kQuick_s), to - from);
  double most = 0;
  for (int i = from; i + step <= to; ++i) most = std::max(most, values[index(i + step)] - values[index(i)]);
  return most;
}

// The longest and fastest way forward between two turning points.
struct Forward {
  int from = 0, to = 0;  // top and end
};
std::optional<Forward> find_forward(const HandPath& path, const std::vector<double>& forward) {
  const double range =
      *std::max_element(forward.begin(), forward.end()) - *std::min_element(forward.begin(), forward.end());
  const double least =
      std::max({kLeastStroke_m, kLeastOverTremble * tremble_of(forward), kLeastPart * range});
  const std::vector<Extreme> turns = extremes(forward, least);
  std::optional<Forward> best;
  double most = 0;
  for (std::size_t k = 0; k + 1 < turns.size(); ++k) {
    const int from = turns[k].index, to = turns[k + 1].index;
    const bool is_high = path.height[index(index_of_largest(path.height, from, to))] -
                             path.height[index(index_of_smallest(path.height, 0, to))] >
                         kMostRise * path.torso_m;
    if (turns[k].is_peak || is_high) continue;
    const double size = (forward[index(to)] - forward[index(from)]) * quickest_rise(forward, from, to);
    if (size <= most) continue;
    most = size;
    best = Forward{from, to};
  }
  return best;
}

}  // namespace

Result<StrokeMoments> find_putt(const HandPath& path, const std::vector<double>& forward) {
  const std::optional<Forward> stroke = find_forward(path, forward);
  if (!stroke) return fail(ErrorCode::Incomplete, text::no_stroke_seen());
  const int top = stroke->from;
  const auto start = fit_start(forward, 0, top);
  if (!start || start->rest.deviation > kMostAtRest * std::abs(forward[index(top)] - start->rest.mean))
    return fail(ErrorCode::Incomplete, text::no_rest_before_the_stroke());
  const auto impact =
      passing(forward, top, stroke->to, start->rest.mean + kAhead * (start->rest.mean - forward[index(top)]));
  if (!impact) return fail(ErrorCode::Incomplete, text::hands_do_not_come_back());
  const int fastest = index_of_largest(path.speed, static_cast<int>(*impact), stroke->to);
  const auto end = fit_end(forward, fastest);
  StrokeMoments found;
  found.takeaway = start->rest_ends + kVisibleTime * (top - start->rest_ends);
  found.is_rest_seen = end.has_value();
  found.moments = {{"address", static_cast<double>(start->rest_ends)},
                   {"top", vertex_near(forward, top)},
                   {"impact", *impact},
                   {"end", std::max(end ? end->rest_ends : path.count() - 1.0, *impact + 1)}};
  return found;
}

}  // namespace posecoach
