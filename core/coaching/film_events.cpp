#include "core/coaching/film_events.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>
#include <vector>

#include "core/base/index.h"
#include "core/coaching/body_axes.h"
#include "core/coaching/hand_path.h"
#include "core/coaching/signal.h"
#include "core/coaching/way_fit.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

// Seconds to each side of the hands' turn that its middle is read from.
constexpr double kSwingTurn_s = 0.12, kPuttTurn_s = 0.2;
// Of the hands' rise from address until the lead arm is level, done when the shaft is.
constexpr double kToeUpRise = 0.35;
// Before the hands' first visible movement, which is seen late: their rest.
constexpr double kRestBefore_s = 0.25, kRestLooked_s = 0.3;
constexpr double kShortestStart_s = 0.15, kLongestStart_s = 1.6;
// Of a putt: the shoulder line trembles more than it moves in a frame, and goes to and fro for longer.
constexpr double kShoulderSmoothing_s = 0.035, kPuttTop_s = 0.3, kShortestPutt_s = 0.2, kLongestPutt_s = 3;
// Of its way back, at two places on the way to the ball, and what the time between them is multiplied by.
constexpr double kEarlyOnWay = 0.85, kLateOnWay = 0.4, kToBall = 1.6;
constexpr double kRest_s = 0.4, kLeastRest_s = 0.1;
constexpr double kShortestEnd_s = 0.25, kLongestEnd_s = 2;
// Of several that tell the finish, who is further off than this is not believed.
constexpr double kFarFromOthers_s = 0.2;

int samples(double seconds) {
  return static_cast<int>(std::lround(seconds * kHandPathRate));
}

int sample_of(const HandPath& path, double time_s) {
  return std::clamp(samples(time_s - path.begin_s), 0, path.count() - 1);
}

double mean_of(const std::vector<double>& values, int first, int last) {
  double sum = 0;
  for (int i = first; i <= last; ++i) sum += values[index(i)];
  return sum / (last - first + 1);
}

// A joint, or a joint over another.
struct Seen {
  HumanoidJoint joint;
  std::optional<HumanoidJoint> over = {};
  bool is_level = false;  // what rises and falls does not count
};

// Part of the body that comes to rest with the hands. Of the time that it truly takes from the follow-through
// on, a pose model shows it settle sooner or later.
struct Settling {
  std::vector<Seen> seen;
  double longer = 1, later_s = 0;
};
const std::vector<Settling>& settling_face_on() {
  static const std::vector<Settling> kAll = {{{{Head}}, 1.08, -0.047}};
  return kAll;
}
// What the camera behind him sees best, besides the head, is the side of the trail hand.
const std::vector<Settling>& settling_down_the_line() {
  static const std::vector<Settling> kAll = {{{{Head, Pelvis}, {Neck, Pelvis}}, 1.36, -0.028},
                                             {{{RightHip, {}, true}}, 0.73, 0.084},
                                             {{{RightShoulder, Pelvis}}, 1.38, -0.038}};
  return kAll;
}

// How far joints have gone, each in the direction of its own way in the picture from where it is between
// `from` and `until` to where it is at `goal`, weighed by that way's length; in samples of `fine`.
std::vector<double> way_in_picture(const JointTrack& fine, const Sight& sight, const std::vector<Seen>& seen,
                                   std::pair<int, int> rest, int goal) {
  std::vector<double> way(index(fine.frame_count()), 0.0);
  for (const Seen& one : seen) {
    const auto place = [&](int i) {
      Vec3 p = fine.position(i, one.joint) - (one.over ? fine.position(i, *one.over) : Vec3(0));
      if (one.is_level) p.y = 0;
      return p - glm::dot(p, *sight.direction) * *sight.direction;
    };
    Vec3 rests(0);
    for (int i = rest.first; i <= rest.second; ++i)
      rests += place(i) / static_cast<double>(rest.second - rest.first + 1);
    const Vec3 goes = place(goal) - rests;
    for (int i = 0; i < fine.frame_count(); ++i) way[index(i)] += glm::dot(place(i) - rests, goes);
  }
  return way;
}

}  // namespace

// From in front of a swing how high the hands are tells it (their depth hides the rest), from down the line
// how far they are from where they rested, and over a putt their way to the target.
double top_in_film(const SeenStroke& stroke) {
  const SwingEvents& found = stroke.found;
  const bool is_putt = found.kind == StrokeKind::Putt, is_face_on = stroke.view == Viewpoint::FaceOn;
  const HandPath path =
      is_putt ? make_putt_path(stroke.track, stroke.sight) : make_hand_path(stroke.track, stroke.sight);
  const double looked_s = 2 * kSwingTurn_s * stroke.slow;
  std::vector<double> way;
  if (is_putt) {
    const BodyAxes axes = body_axes(stroke.track, stroke.track.time(0), stroke.track.duration());
    for (const Vec3& hands : path.hands) way.push_back(-glm::dot(hands, axes.left));
  } else if (is_face_on) {
    way = path.height;
  } else {
    const Vec3 rest = path.hands[index(sample_of(path, found.time_of("address")))];
    for (const Vec3& hands : path.hands) way.push_back(glm::distance(hands, rest));
  }
  const int highest = index_of_largest(way, sample_of(path, found.time_of("top") - looked_s),
                                       sample_of(path, found.time_of("top") + looked_s));
  const double half = (is_putt ? kPuttTurn_s : kSwingTurn_s) * stroke.slow * kHandPathRate;
  const int degree = !is_putt && is_face_on ? 3 : 2;
  return path.time(peak_of_curve(way, highest, half, degree));
}

std::optional<PuttDownTheLine> putt_down_the_line(const SeenStroke& stroke) {
  if (!stroke.sight.direction) return std::nullopt;
  const double slow = stroke.slow;
  const HandPath path = make_hand_path(stroke.track, stroke.sight);
  const Vec3 across = glm::cross(Vec3(0, 1, 0), *stroke.sight.direction);
  std::vector<double> way;
  for (const Vec3& line : path.shoulder_line) way.push_back(glm::dot(line, across));
  way = smoothed(way, kShoulderSmoothing_s * slow * kHandPathRate);
  const double top_s = stroke.found.time_of("top");
  const int rested = sample_of(path, stroke.found.takeaway_s - kRestBefore_s * slow);
  if (way[index(sample_of(path, top_s))] < way[index(rested)])
    for (double& gone : way) gone = -gone;
  const int highest = index_of_largest(way, sample_of(path, top_s - kPuttTop_s * slow),
                                       sample_of(path, top_s + kPuttTop_s * slow));
  const auto start =
      fit_rest_before(way, std::max(samples(kLeastRest_s * slow), highest - samples(kLongestPutt_s * slow)),
                      highest - samples(kShortestPutt_s * slow), highest, samples(kRest_s * slow));
  if (!start) return std::nullopt;
  const double rest = mean_of(way, std::max(0, *start - samples(kRest_s * slow)), *start);
  const auto on_way = [&](double part) {
    return crossing(way, highest, path.count() - 1, rest + part * (way[index(highest)] - rest));
  };
  const auto early = on_way(kEarlyOnWay), late = on_way(kLateOnWay);
  if (!early || !late) return std::nullopt;
  return PuttDownTheLine{path.time(*start),
                         path.time(peak_of_curve(way, highest, samples(kPuttTurn_s * slow), 2)),
                         path.time(*early + kToBall * (*late - *early))};
}

std::optional<double> toe_up_down_the_line(const SeenStroke& stroke) {
  const HandPath path = make_hand_path(stroke.track, stroke.sight);
  const double rested_s = stroke.found.takeaway_s - kRestBefore_s * stroke.slow;
  std::vector<double> height;
  for (const Vec3& arms : path.arms) height.push_back(arms.y);
  const int rest = sample_of(path, rested_s), level = sample_of(path, stroke.found.time_of("mid_backswing"));
  const double hanging = mean_of(height, sample_of(path, rested_s - 0.5 * kRestLooked_s * stroke.slow), rest);
  const auto crossed = crossing(height, level, rest, hanging + kToeUpRise * (height[index(level)] - hanging));
  return crossed ? std::optional(path.time(*crossed)) : std::nullopt;
}

std::optional<double> takeaway_down_the_line(const SeenStroke& stroke, double toe_up_s) {
  if (!stroke.sight.direction) return std::nullopt;
  const double slow = stroke.slow;
  const double begin_s = std::max(0.0, toe_up_s - (kLongestStart_s + kRest_s) * slow);
  const JointTrack fine = stroke.track.resampled(kHandPathRate, begin_s, toe_up_s);
  const int goal = fine.frame_count() - 1;
  const auto sample = [&](double time_s) { return std::clamp(samples(time_s - begin_s), 0, goal); };
  const double rested_s = stroke.found.takeaway_s - kRestBefore_s * slow;
  const std::pair rest(sample(rested_s - kRestLooked_s * slow), sample(rested_s));
  double sum = 0;
  for (const Seen& one : {Seen{LeftShoulder}, Seen{RightWrist, {}, true}}) {
    const auto start =
        fit_rest_before(way_in_picture(fine, stroke.sight, {one}, rest, goal), samples(kLeastRest_s * slow),
                        goal - samples(kShortestStart_s * slow), goal, samples(kRest_s * slow));
    if (!start) return std::nullopt;
    sum += 0.5 * fine.time(*start);
  }
  return sum;
}

std::optional<double> finish_in_film(const SeenStroke& stroke) {
  if (!stroke.sight.direction || !stroke.found.is_end_seen || !stroke.track.has(Head)) return std::nullopt;
  const double slow = stroke.slow;
  const double begin_s = stroke.found.time_of("mid_follow_through"), rests_s = stroke.found.time_of("finish");
  const JointTrack fine =
      stroke.track.resampled(kHandPathRate, begin_s, begin_s + (kLongestEnd_s + kRest_s) * slow);
  const int last = fine.frame_count() - 1;
  const auto sample = [&](double time_s) { return std::clamp(samples(time_s - begin_s), 0, last); };
  const std::pair rest(sample(rests_s), sample(rests_s + kRest_s * slow));
  std::vector<double> told_s;
  for (const Settling& one :
       stroke.view == Viewpoint::FaceOn ? settling_face_on() : settling_down_the_line()) {
    const auto end = fit_rest_after(
        way_in_picture(fine, stroke.sight, one.seen, rest, 0), 0, samples(kShortestEnd_s * slow),
        std::min(samples(kLongestEnd_s * slow), last - samples(kLeastRest_s)), samples(kRest_s * slow));
    if (end) told_s.push_back(one.later_s * slow + one.longer * (fine.time(*end) - begin_s));
  }
  if (told_s.empty()) return std::nullopt;
  std::sort(told_s.begin(), told_s.end());
  const double middle = told_s[told_s.size() / 2];
  std::erase_if(told_s, [&](double told) { return std::abs(told - middle) > kFarFromOthers_s * slow; });
  return begin_s + std::accumulate(told_s.begin(), told_s.end(), 0.0) / static_cast<double>(told_s.size());
}

}  // namespace posecoach
