#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/index.h"
#include "core/coaching/signal.h"
#include "core/coaching/stroke_search.h"
#include "core/coaching/text/refusal_text.h"

namespace posecoach {
namespace {

// How much of the arms' way from hanging to level, in height, is done when the shaft is level: it is already
// turned in the wrists by then.
constexpr double kToeUpPart = 0.45;
constexpr int kSide = 2;  // samples to each side of a vertex that are looked at

// Where the arms are level between the top and `end`, or, for a short swing, three quarters of the way up. At
// the top of a film they may seem to dip: what is nearest to `end` is meant.
double level_or_part(const std::vector<double>& elevation, const std::vector<double>& way, int top, int end) {
  if (elevation[index(top)] > 0)
    if (const auto level = crossing(elevation, end, top, 0)) return *level;
  return crossing(way, top, end, 0.75 * way[index(top)]).value_or(0.5 * (top + end));
}

double fine_vertex(const std::vector<double>& values, int i) {
  // Over a few samples, so that a film's jitter moves it less.
  std::vector<double> thinned;
  const int count = static_cast<int>(values.size());
  for (int k = -1; k <= 1; ++k) thinned.push_back(values[index(std::clamp(i + k * kSide, 0, count - 1))]);
  return i + kSide * (vertex_near(thinned, 1) - 1);
}

}  // namespace

Result<StrokeMoments> find_full_swing(const HandPath& path, const SwingBow& bow,
                                      const std::vector<Vec3>& lead_arms,
                                      const std::vector<Vec3>& trail_arms) {
  const int before = index_of_smallest(path.height, 0, bow.top);
  const double half_height = 0.5 * (path.height[index(before)] + path.height[index(bow.top)]);
  const auto half_up = crossing(path.height, bow.top, before, half_height);
  if (!half_up) return fail(ErrorCode::Incomplete, text::begins_in_the_backswing());
  const int rising = static_cast<int>(*half_up);
  const double back_speed =
      path.unweighted_speed[index(index_of_largest(path.unweighted_speed, rising, bow.top))];
  const auto start = find_start(path, rising, back_speed);
  if (!start) return fail(ErrorCode::Incomplete, text::no_rest_before_the_stroke());

  const std::vector<double> way = distance_from_rest(path, *start);
  const int top = index_of_largest(way, rising, bow.low);
  const auto half_down = crossing(path.height, top, bow.low, half_height);
  if (!half_down) return fail(ErrorCode::Incomplete, text::hands_stay_up());
  const int impact = index_of_smallest(way, static_cast<int>(*half_down), bow.follow);
  if (impact >= bow.follow) return fail(ErrorCode::Incomplete, text::ends_before_impact());

  const std::vector<double> lead = elevation_deg(lead_arms), both = elevation_deg(path.arms);
  const int address = static_cast<int>(start->address);
  StrokeMoments found;
  found.takeaway = start->takeaway;
  const double mid_backswing = level_or_part(lead, way, top, static_cast<int>(std::ceil(found.takeaway)));
  const double mid_downswing = level_or_part(lead, way, top, impact);
  const double hanging = both[index(address)];
  const double toe_up = crossing(both, static_cast<int>(mid_backswing), address,
                                 hanging + kToeUpPart * (value_at(both, mid_backswing) - hanging))
                            .value_or(0.5 * (found.takeaway + mid_backswing));
  const auto level = crossing(elevation_deg(trail_arms), impact, bow.follow, 0);
  const double follow_through = level ? *level
                                      : crossing(way, impact, bow.follow, 0.75 * way[index(bow.follow)])
                                            .value_or(0.5 * (impact + bow.follow));
  const double through_speed = path.speed[index(index_of_largest(path.speed, impact, bow.follow))];
  const double finish = find_rest(path, static_cast<int>(std::ceil(follow_through)), through_speed);
  found.is_rest_seen = finish < path.count() - 1;
  found.moments = {{"address", start->address},
                   {"toe_up", std::max(toe_up, found.takeaway)},
                   {"mid_backswing", mid_backswing},
                   {"top", fine_vertex(way, top)},
                   {"mid_downswing", mid_downswing},
                   {"impact", fine_vertex(way, impact)},
                   {"mid_follow_through", follow_through},
                   {"finish", finish}};
  return found;
}

}  // namespace posecoach
