// One file a command: each adds itself to the command line, and runs when it was named. A command's function
// returns its Error instead of printing it; main prints it once and exits with 1.
#pragma once

#include <functional>

#include "core/base/error.h"

namespace CLI {
class App;
}

namespace posecoach {

// What the parsed command line wants done; set by the command's callback, run by main.
using Action = std::function<Result<void>()>;

}  // namespace posecoach
