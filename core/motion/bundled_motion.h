// The golf motions that the program carries inside itself, on an average body of 1.80 m, right-handed.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/motion/authored/authored_motion.h"

namespace posecoach {

// "swing" and "putt".
const std::vector<std::string>& bundled_motion_names();

// Errors: NotFound listing the names that there are.
Result<GolfScript> bundled_script(std::string_view name);
// At 120 frames per second.
Result<AuthoredMotion> bundled_authored_motion(std::string_view name);
Result<Motion> bundled_motion(std::string_view name);

}  // namespace posecoach
