// How the program says what is wrong: one line, whatever the cause.
#pragma once

#include <string>

namespace CLI {
class App;
class Error;
}  // namespace CLI

namespace posecoach {

// What is wrong with the command line, and where to read how it is right.
std::string usage_line(const CLI::App* cli, const CLI::Error& error);

// Prints it to standard error; the exit code of a failure.
int fail_with(const std::string& message);

}  // namespace posecoach
