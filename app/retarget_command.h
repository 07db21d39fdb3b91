// posecoach retarget --motion M --body B -o OUT: the coach's motion in another body.
#pragma once

#include "app/commands.h"

namespace posecoach {

void add_retarget_command(CLI::App& cli, Action& action);

}  // namespace posecoach
