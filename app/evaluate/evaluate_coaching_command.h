// posecoach evaluate coaching: how many known faults are named, through true joints and through film.
#pragma once

#include "app/commands.h"

namespace posecoach {

// `evaluate` is the command that the task belongs to.
void add_evaluate_coaching_command(CLI::App& evaluate, Action& action);

}  // namespace posecoach
