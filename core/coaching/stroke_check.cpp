#include "core/coaching/stroke_check.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/median.h"
#include "core/coaching/pendulum.h"
#include "core/coaching/posture.h"
#include "core/coaching/text/refusal_text.h"

namespace posecoach {
namespace {

using enum HumanoidJoint;

// In torsos, which are half a metre long. A webcam's wrists on one grip can seem a torso's half apart.
constexpr double kMostHandsApart = 0.5, kMostHandsApartOneCamera = 0.75;
constexpr double kMostFeetMoved = 0.4, kMostFeetMovedOneCamera = 0.6;
// Of the hands' way from address to top.
constexpr double kMostMissAtImpact = 0.6;
constexpr double kPuttMean_s = 0.05;
// Backswing over downswing; hurried and lazy golfers are well inside.
constexpr double kLeastTempo = 0.7, kMostTempo = 9;
constexpr double kLeastTurn_deg = 20;

tl::unexpected<Error> no_stroke(const std::string& why) {
  return fail(ErrorCode::Unsupported, text::no_golf_stroke(why));
}

}  // namespace

Result<void> check_stroke(const JointTrack& track, const SwingEvents& swing, const Sight& sight) {
  const bool one_camera = sight.direction.has_value();
  const int address = track.nearest_frame(swing.time_of("address")),
            top = track.nearest_frame(swing.time_of("top")),
            impact = track.nearest_frame(swing.time_of("impact"));
  std::vector<double> torso, apart;
  for (int frame = address; frame <= impact; ++frame) {
    torso.push_back(glm::distance(track.position(frame, Neck), track.position(frame, Pelvis)));
    apart.push_back(
        glm::length(sight.seen(track.position(frame, LeftWrist) - track.position(frame, RightWrist))));
  }
  const double torso_m = std::max(0.1, median(std::move(torso))), apart_m = median(std::move(apart));
  if (apart_m > torso_m * (one_camera ? kMostHandsApartOneCamera : kMostHandsApart))
    return no_stroke(text::hands_apart(apart_m));
  const double walked_m = glm::length(sight.seen(middle_of(track, impact, LeftAnkle, RightAnkle) -
                                                 middle_of(track, address, LeftAnkle, RightAnkle)));
  if (walked_m > torso_m * (one_camera ? kMostFeetMovedOneCamera : kMostFeetMoved))
    return no_stroke(text::feet_walk(walked_m));
  const Pendulum pendulum(putt_posture(track), swing.kind == StrokeKind::Putt ? sight : Sight{});
  const auto hands_at = [&](int frame) {
    const Vec3 middle = middle_of(track, frame, LeftWrist, RightWrist) - track.position(frame, Pelvis);
    if (swing.kind == StrokeKind::FullSwing) return sight.seen(middle);
    return pendulum.hands(middle, track.position(frame, LeftShoulder) - track.position(frame, RightShoulder));
  };
  // A filmed putt moves as little as its joints tremble.
  const auto hands = [&](int frame) {
    if (swing.kind == StrokeKind::FullSwing) return hands_at(frame);
    Vec3 sum(0);
    const int first = track.nearest_frame(track.time(frame) - kPuttMean_s),
              last = track.nearest_frame(track.time(frame) + kPuttMean_s);
    for (int f = first; f <= last; ++f) sum += hands_at(f);
    return sum / static_cast<double>(last - first + 1);
  };
  const double way_m = glm::distance(hands(top), hands(address)),
               miss_m = glm::distance(hands(impact), hands(address));
  if (miss_m > kMostMissAtImpact * way_m) return no_stroke(text::hands_miss_the_ball(miss_m));
  const double back_s = swing.time_of("top") - swing.takeaway_s,
               down_s = swing.time_of("impact") - swing.time_of("top");
  if (back_s < kLeastTempo * down_s || back_s > kMostTempo * down_s)
    return no_stroke(text::no_golf_tempo(back_s, down_s));
  if (swing.kind == StrokeKind::FullSwing && !one_camera) {
    const BodyAxes axes = body_axes(track, track.time(address), track.time(address));
    const double turned = std::remainder(turn_deg(track, top, LeftShoulder, RightShoulder, axes) -
                                             turn_deg(track, address, LeftShoulder, RightShoulder, axes),
                                         360.0);
    if (std::abs(turned) < kLeastTurn_deg) return no_stroke(text::chest_does_not_turn(std::abs(turned)));
  }
  return {};
}

}  // namespace posecoach
