// `posecoach train retarget`.
#pragma once

#include "app/commands.h"

namespace posecoach {

void add_train_retarget_command(CLI::App& train, Action& action);

}  // namespace posecoach
