// The golfer's numbers, with what they are worth: definition, plus-minus, and whether view, frame rate and
// confidence can carry them. Signs never depend on the hand: towards the target, up and towards the ball are
// positive; turns are positive towards the target, except at the top, where the turn back counts.
#pragma once

#include <vector>

#include "core/coaching/analysis.h"
#include "core/coaching/spatial_advice.h"

namespace posecoach {

std::vector<Metric> measure_swing(const ComparedSwings& swings);

}  // namespace posecoach
