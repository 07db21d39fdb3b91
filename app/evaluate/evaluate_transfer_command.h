// `posecoach evaluate transfer`: the tables of the 2D pose transfer.
#pragma once

#include "app/commands.h"

namespace posecoach {

// `evaluate` is the command that the task belongs to.
void add_evaluate_transfer_command(CLI::App& evaluate, Action& action);

}  // namespace posecoach
