// The window from its opening until the user leaves it.
#pragma once

#include "app/window/window_program.h"

namespace posecoach {

// Errors: no display, no OpenGL, the pose networks are missing.
Result<void> run_window(const LiveArguments& arguments, const LiveDevices& devices = {});

}  // namespace posecoach
