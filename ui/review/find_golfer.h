// Where in a film somebody swings.
#pragma once

#include <optional>
#include <utility>

#include "core/pipeline/analyzed_swing.h"

namespace posecoach {

// Around all that is seen of the golfer during the stroke, with room for the club, in pixels of the film;
// nothing where he was not seen.
std::optional<std::pair<Vec2, Vec2>> find_golfer(const AnalyzedSwing& swing);

}  // namespace posecoach
