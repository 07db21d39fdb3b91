// Whether what a command is to write can be written: found before the long work starts.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"

namespace posecoach {

// Empty names and devices are left out; "-" is standard output. No output is a folder, stands in a folder
// that is missing or closed to us, is named twice, or is one of the inputs, which writing it would destroy.
// Errors: NotFound, Unreadable, InvalidArgument.
Result<void> check_output_files(const std::vector<std::string>& outputs,
                                const std::vector<std::string>& inputs);

}  // namespace posecoach
