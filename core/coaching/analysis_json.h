// The analysis as the "posecoach.analysis/1" contract (fields are added, never renamed).
#pragma once

#include <string>

#include "core/coaching/analysis.h"

namespace posecoach {

std::string to_json(const Analysis& analysis);

}  // namespace posecoach
