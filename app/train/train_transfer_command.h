// `posecoach train transfer`.
#pragma once

#include "app/commands.h"

namespace posecoach {

// `train` is the command that the task belongs to.
void add_train_transfer_command(CLI::App& train, Action& action);

}  // namespace posecoach
