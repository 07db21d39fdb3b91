// The named moments of a golf stroke, found from the body alone (nobody sees the club or the ball): the path
// of the hands over the pelvis, and the arms against the horizon.
//
// Full swing, after GolfDB's names: address (the last still moment), toe_up (arms nearly half the way up to
// level), mid_backswing (arms level), top (hands farthest from the address), mid_downswing (arms level),
// impact (hands nearest to the address), mid_follow_through (arms level), finish (hands at rest). Putt:
// address, top, impact, end.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/body/mirror.h"
#include "core/coaching/analysis.h"
#include "core/coaching/joint_track.h"
#include "core/coaching/sight.h"

namespace posecoach {

enum class StrokeKind { FullSwing, Putt };
std::string_view to_string(StrokeKind kind);

struct SwingEvents {
  StrokeKind kind = StrokeKind::FullSwing;
  Handedness hand = Handedness::Right;
  // When the hands have visibly left the address; the backswing is measured from here.
  double takeaway_s = 0;
  // Whether the hands come to rest before the motion ends; if not, its last frame stands for the last event.
  bool is_end_seen = true;
  std::vector<SwingEvent> events;  // in the order of time; sub-frame times from the motion's first frame

  // Asserts that there is one of this name ("takeaway" counts).
  double time_of(std::string_view name) const;
};

struct SegmentationOptions {
  std::optional<Handedness> hand = {};  // detected when not given
  Sight sight = {};
};

// Errors: Incomplete with the reason why no stroke could be found or which part of it is missing; Unsupported
// where the hands move as in a stroke but nobody plays golf (core/coaching/stroke_check.h).
Result<SwingEvents> find_swing_events(const JointTrack& track, const SegmentationOptions& options = {});

}  // namespace posecoach
