// posecoach analyze: the main job, headless.
#pragma once

#include "app/commands.h"

namespace posecoach {

void add_analyze_command(CLI::App& cli, Action& action);

}  // namespace posecoach
