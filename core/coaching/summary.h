// The analysis in a few plain lines for a terminal.
#pragma once

#include <string>

#include "core/coaching/analysis.h"

namespace posecoach {

std::string summary(const Analysis& analysis);

}  // namespace posecoach
