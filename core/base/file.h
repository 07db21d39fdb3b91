// Whole files in and out.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace posecoach {

// The whole file as bytes. Errors: NotFound, Unreadable (a directory, no permission), Unsupported (over
// `max_bytes`).
Result<std::string> read_file(const std::filesystem::path& path,
                              std::size_t max_bytes = std::size_t{1} << 30);

// Writes beside `path`, syncs, then renames: afterwards the file is the old one or the new one, never half of
// it. The path "-" is standard output. Errors: Unreadable with the reason (folder missing, disk full, no
// permission).
Result<void> write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

}  // namespace posecoach
