// The program's log, on standard error. An error is logged where it is handled, once, with the file's or
// device's name.
#pragma once

#include <string_view>

namespace posecoach::log {

void info(std::string_view message);
void warning(std::string_view message);
void error(std::string_view message);

}  // namespace posecoach::log
