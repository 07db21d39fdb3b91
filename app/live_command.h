#pragma once

#include "app/commands.h"

namespace posecoach {

// `live`, and what the program does without a command.
void add_live_command(CLI::App& cli, Action& action);

}  // namespace posecoach
