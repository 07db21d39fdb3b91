// posecoach simulate: a film of the simulated student, and the truth about it.
#pragma once

#include "app/commands.h"

namespace posecoach {

void add_simulate_command(CLI::App& cli, Action& action);

}  // namespace posecoach
