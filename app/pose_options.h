// The pose stage's options, the same for every command that looks at pictures.
#pragma once

#include <memory>

#include "core/vision/pose_tracker.h"

namespace CLI {
class App;
}

namespace posecoach {

// Adds --model and --models. What they say is in the result once the command line was parsed.
std::shared_ptr<PoseTrackerOptions> add_pose_options(CLI::App& command);

const char* to_string(PoseModel model);

}  // namespace posecoach
