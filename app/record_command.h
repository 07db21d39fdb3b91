// `posecoach record`: a film of whatever a source gives, with every frame that it gave.
#pragma once

#include "app/commands.h"

namespace posecoach {

void add_record_command(CLI::App& cli, Action& action);

}  // namespace posecoach
