// posecoach library: the recorded swings from the command line.
#pragma once

#include "app/commands.h"

namespace posecoach {

void add_library_command(CLI::App& cli, Action& action);

}  // namespace posecoach
