// Runs the built posecoach and keeps what it said.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace posecoach {

struct ProgramRun {
  int exit_code = -1;  // -1: ended by a signal
  std::string output, error;
};

enum class Interrupt { Never, AfterFirstFile };

// With AfterFirstFile the program gets what Ctrl-C sends as soon as anything stands in `watched`.
ProgramRun run_posecoach(const std::vector<std::string>& arguments, Interrupt interrupt = Interrupt::Never,
                         const std::filesystem::path& watched = {});

}  // namespace posecoach
