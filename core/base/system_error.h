#pragma once

#include <filesystem>

#include "core/base/error.h"

namespace posecoach {

// What errno says now: "cannot open /path: Permission denied".
Error system_error(const char* verb, const std::filesystem::path& path);

}  // namespace posecoach
