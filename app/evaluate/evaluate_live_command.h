// posecoach evaluate live: does the hands-free loop find every stroke in time, and does the ghost keep up?
#pragma once

#include "app/commands.h"

namespace posecoach {

// `evaluate` is the command that the task belongs to.
void add_evaluate_live_command(CLI::App& evaluate, Action& action);

}  // namespace posecoach
