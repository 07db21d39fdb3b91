// Data for development that lies beside the repository and not in it; tests that use it skip where it is
// absent.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace posecoach {

// The file or folder of that name in the folder that the environment variable POSECOACH_SHARED names, or else
// in `shared` beside the source folder. Nothing when it is not there.
std::optional<std::filesystem::path> shared_data(std::string_view name);

}  // namespace posecoach
