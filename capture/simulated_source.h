// The simulated student's name as a source:
//
//   simulated:putt
//   simulated:swing?fault=early_extension&amount=8&body=tall&view=down-the-line&hand=left&fps=60&size=1280x720
//
// `fault` may be given several times, as sway or sway=8; `amount` is that of the fault before it. `body` is a
// name or a .body.json or motion file.
#pragma once

#include <string>
#include <string_view>

#include "capture/simulated_student.h"

namespace posecoach {

bool is_simulated_source(std::string_view source);

// Errors: InvalidArgument, NotFound, each naming the part that is wrong and what it may be; a body file's
// own.
Result<SimulatedStudentOptions> simulated_student_from_source(const std::string& source);

// One setting, "body" = "tall". Used by the command line as well.
Result<void> set_simulated_option(SimulatedStudentOptions& options, std::string_view key,
                                  const std::string& value);

}  // namespace posecoach
