// posecoach bench: how fast every stage is on this machine.
#pragma once

#include "app/commands.h"

namespace posecoach {

void add_bench_command(CLI::App& cli, Action& action);

}  // namespace posecoach
