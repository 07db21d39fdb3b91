// posecoach evaluate pose --data DIR: agreement with another program's answers.
#pragma once

#include "app/commands.h"

namespace posecoach {

// `evaluate` is the command that the task belongs to.
void add_evaluate_pose_command(CLI::App& evaluate, Action& action);

}  // namespace posecoach
