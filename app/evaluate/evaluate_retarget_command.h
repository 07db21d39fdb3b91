// posecoach evaluate retarget --data DIR: retargeting against what other characters really did.
#pragma once

#include "app/commands.h"

namespace posecoach {

// `evaluate` is the command that the task belongs to.
void add_evaluate_retarget_command(CLI::App& evaluate, Action& action);

}  // namespace posecoach
