// posecoach body INPUT -o OUT.body.json: bone lengths and T-pose of the person or skeleton in INPUT.
#pragma once

#include "app/commands.h"

namespace posecoach {

void add_body_command(CLI::App& cli, Action& action);

}  // namespace posecoach
