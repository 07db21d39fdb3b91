// The names that golfers know for what differs: a sway, early extension, a chicken wing. The same names as
// the authored faults have (core/motion/authored/golf_fault.h).
#pragma once

#include <string_view>

#include "core/coaching/part_differences.h"
#include "core/coaching/swing_events.h"

namespace posecoach {

// Empty where golfers have no name for it. `amount` as in PartDifference.
std::string_view known_fault(Feature feature, double amount, std::string_view event, StrokeKind kind);

// Of a phase between two events that takes `ratio` times as long as the coach's.
std::string_view known_timing_fault(std::string_view from, std::string_view to, double ratio,
                                    StrokeKind kind);

}  // namespace posecoach
