// posecoach pose INPUT -o OUT.pose.json: 2D and 3D joints of every frame.
#pragma once

#include "app/commands.h"

namespace posecoach {

void add_pose_command(CLI::App& cli, Action& action);

}  // namespace posecoach
