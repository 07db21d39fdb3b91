// `posecoach transfer`: a pose in another person's proportions, from pictures alone.
#pragma once

#include "app/commands.h"

namespace posecoach {

void add_transfer_command(CLI::App& cli, Action& action);

}  // namespace posecoach
