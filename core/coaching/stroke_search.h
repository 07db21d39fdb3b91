// Inside find_swing_events: where in the film the stroke is, and its moments, in samples of the hand path.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/coaching/hand_path.h"

namespace posecoach {

// The hands rise, fall and rise again: around a full swing's impact.
struct SwingBow {
  int top = 0, low = 0, follow = 0;
};
// The fastest of all bows; nothing when the hands never go up and down and up again.
std::optional<SwingBow> find_bow(const HandPath& path);

struct StrokeMoment {
  std::string name;
  double index = 0;
};
struct StrokeMoments {
  double takeaway = 0;
  bool is_rest_seen = false;  // whether the hands come to rest before the motion ends
  std::vector<StrokeMoment> moments;
};

// `lead_arms`: from between the lead shoulder and the neck to the hands; `trail_arms` likewise.
Result<StrokeMoments> find_full_swing(const HandPath& path, const SwingBow& bow,
                                      const std::vector<Vec3>& lead_arms,
                                      const std::vector<Vec3>& trail_arms);

// `forward` is the hands' way towards the target, metres.
Result<StrokeMoments> find_putt(const HandPath& path, const std::vector<double>& forward);

// The still moment before a stroke's first movement, and the first visible movement: going back from
// `moving`, where the stroke is certainly on its way. Nothing when the hands never rest before.
struct StrokeStart {
  double address = 0, takeaway = 0;
  int rest_first = 0, rest_last = 0;  // where the hands rest
};
std::optional<StrokeStart> find_start(const HandPath& path, int moving, double largest_speed);

// How far each wrist is from where it rested, root mean square; a wrist that was hidden there counts less.
std::vector<double> distance_from_rest(const HandPath& path, const StrokeStart& start);

// Where the hands come to rest after `moving`; the last sample when the film ends first.
double find_rest(const HandPath& path, int moving, double largest_speed);

}  // namespace posecoach
