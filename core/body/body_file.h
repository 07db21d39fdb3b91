// The "posecoach.body/1" file: a body's joints in T-pose.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/body/skeleton.h"

namespace posecoach {

// {"schema", "height_m", "joints": [{"name", "parent": name or null, "role": canonical name where it has one,
// "offset_m": [x, y, z]}]}
std::string body_to_json(const Skeleton& body);

// `name` stands in messages. A joint without "role" that is called like a canonical joint or like a landmark
// gets that role. Errors: Malformed with file and line; Unsupported (over 4096 joints).
Result<Skeleton> body_from_json(std::string_view json, std::string_view name);

Result<Skeleton> read_body_file(const std::filesystem::path& path);
Result<void> write_body_file(const std::filesystem::path& path, const Skeleton& body);

}  // namespace posecoach
