// `posecoach cameras`: the cameras of this machine, with their modes.
#pragma once

#include "app/commands.h"

namespace posecoach {

void add_cameras_command(CLI::App& cli, Action& action);

}  // namespace posecoach
