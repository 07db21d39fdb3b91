#include "core/coaching/swing_events.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/assert.h"
#include "core/coaching/body_axes.h"
#include "core/coaching/signal.h"
#include "core/coaching/stroke_check.h"
#include "core/coaching/stroke_search.h"
#include "core/coaching/text/refusal_text.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

// A camera whose line of sight is nearer to the target line than to the ball.
constexpr double kHidesTargetLine = 0.7;
// Of a filmed putt seen along the target line; trembling shoulders alone make half of it.
constexpr double kLeastWayBackHidden_m = 0.018;

double vote(double value, double sure_at) {
  return std::clamp(value / sure_at, -1.0, 1.0);
}

// How far the right hand is below the left on the grip, metres: the trail hand is the lower one.
double right_hand_lower(const JointTrack& track, int first, int last) {
  double sum = 0, total = 1e-9;
  for (int frame = first; frame <= last; ++frame) {
    const double weight =
        std::min(track.confidence(frame, LeftWrist), track.confidence(frame, RightWrist)) + 1e-3;
    sum += weight * (track.position(frame, LeftWrist).y - track.position(frame, RightWrist).y);
    total += weight;
  }
  return sum / total;
}

double chest_heading(const JointTrack& track, int frame) {
  const Vec3 left = track.position(frame, LeftShoulder) - track.position(frame, RightShoulder);
  return std::atan2(-left.z, left.x);
}

// Three witnesses: where the hands go, which way the chest turns, which hand is lower.
Handedness hand_of_swing(const JointTrack& track, const HandPath& path, const SwingBow& bow) {
  int low =
      index_of_smallest(path.height, std::max(0, bow.top - static_cast<int>(2 * kHandPathRate)), bow.top);
  const double address_s = path.time(low), top_s = path.time(bow.top);
  const BodyAxes axes = body_axes(track, address_s - 0.1, address_s + 0.1);
  const Vec3 moved =
      path.hands[static_cast<std::size_t>(bow.top)] - path.hands[static_cast<std::size_t>(low)];
  const int a = track.nearest_frame(address_s), t = track.nearest_frame(top_s);
  const double turn = std::remainder(chest_heading(track, t) - chest_heading(track, a), 2 * kPi);
  const double right = vote(-glm::dot(moved, axes.left), 0.2) + vote(-turn, radians_from_degrees(30)) +
                       vote(right_hand_lower(track, std::max(0, a - 5), a), 0.05);
  return right >= 0 ? Handedness::Right : Handedness::Left;
}

std::vector<double> along(const std::vector<Vec3>& positions, const Vec3& direction) {
  std::vector<double> values;
  values.reserve(positions.size());
  for (const Vec3& p : positions) values.push_back(glm::dot(p, direction));
  return values;
}

// Where the hands are fastest, which is through the ball, and the grip.
Handedness hand_of_putt(const JointTrack& track, const HandPath& path, const BodyAxes& axes) {
  constexpr int kHalf = static_cast<int>(0.15 * kHandPathRate);
  const std::vector<double> left = along(path.hands, axes.left);
  double way = 0;
  for (std::size_t i = 2 * kHalf; i < left.size(); ++i)
    if (std::abs(left[i] - left[i - 2 * kHalf]) > std::abs(way)) way = left[i] - left[i - 2 * kHalf];
  const double range =
      *std::max_element(left.begin(), left.end()) - *std::min_element(left.begin(), left.end());
  const double right =
      vote(right_hand_lower(track, 0, track.frame_count() - 1), 0.05) + 2 * vote(way, 0.4 * range + 1e-9);
  return right >= 0 ? Handedness::Right : Handedness::Left;
}

bool hides_target_line(const Sight& sight, const BodyAxes& axes) {
  return sight.direction && std::abs(glm::dot(*sight.direction, axes.left)) > kHidesTargetLine;
}

double way_back_m(const SwingEvents& putt, const HandPath& path, const BodyAxes& axes) {
  const auto left_at = [&](std::string_view event) {
    return value_at(along(path.hands, axes.left), (putt.time_of(event) - path.begin_s) * kHandPathRate);
  };
  return std::abs(left_at("top") - left_at("address"));
}

}  // namespace

std::string_view to_string(StrokeKind kind) {
  return kind == StrokeKind::Putt ? "putt" : "full swing";
}

double SwingEvents::time_of(std::string_view name) const {
  if (name == "takeaway") return takeaway_s;
  for (const SwingEvent& event : events)
    if (event.name == name) return event.time_s;
  POSECOACH_ASSERT(!"no such event");
  return 0;
}

namespace {

Result<SwingEvents> find_events(const JointTrack& track, const SegmentationOptions& options,
                                const HandPath& path, const std::optional<SwingBow>& bow,
                                const BodyAxes& axes) {
  SwingEvents swing;
  swing.kind = bow ? StrokeKind::FullSwing : StrokeKind::Putt;
  swing.hand =
      options.hand.value_or(bow ? hand_of_swing(track, path, *bow) : hand_of_putt(track, path, axes));
  const bool is_right = swing.hand == Handedness::Right;
  const Vec3 target = is_right ? axes.left : -axes.left;
  const Result<StrokeMoments> found =
      bow ? find_full_swing(path, *bow, is_right ? path.left_arms : path.right_arms,
                            is_right ? path.right_arms : path.left_arms)
          : find_putt(path, along(path.hands, target));
  if (!found) return tl::unexpected(found.error());
  swing.takeaway_s = path.time(found->takeaway);
  swing.is_end_seen = found->is_rest_seen;
  for (const StrokeMoment& moment : found->moments) {
    const double time = path.time(moment.index);
    swing.events.push_back({moment.name, track.nearest_frame(time), time});
  }
  for (std::size_t k = 1; k < swing.events.size(); ++k)
    if (swing.events[k].time_s <= swing.events[k - 1].time_s)
      return fail(ErrorCode::Incomplete, text::out_of_order(swing.events[k].name, swing.events[k - 1].name));
  if (hides_target_line(options.sight, axes) && !bow && way_back_m(swing, path, axes) < kLeastWayBackHidden_m)
    return fail(ErrorCode::Incomplete, text::putt_too_short_from_here());
  if (const Result<void> checked = check_stroke(track, swing, options.sight); !checked)
    return tl::unexpected(checked.error());
  return swing;
}

}  // namespace

Result<SwingEvents> find_swing_events(const JointTrack& track, const SegmentationOptions& options) {
  HandPath path = make_hand_path(track, options.sight);
  const auto bow = find_bow(path);
  if (!bow) path = make_putt_path(track, options.sight);
  const BodyAxes axes = body_axes(track, track.time(0), track.duration());
  Result<SwingEvents> found = find_events(track, options, path, bow, axes);
  // Of the shoulders' small way, what is no stroke and what is too little of one look alike.
  if (!found && !bow && found.error().code == ErrorCode::Incomplete && hides_target_line(options.sight, axes))
    return fail(ErrorCode::Incomplete, text::putt_too_short_from_here());
  return found;
}

}  // namespace posecoach
