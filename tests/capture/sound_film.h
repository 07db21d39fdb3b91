// Films with sound, made and measured for tests.
#pragma once

#include <filesystem>
#include <optional>
#include <utility>

namespace posecoach {

// An MP4 with an AAC track of a tone and nothing else. False when this FFmpeg cannot make one.
bool write_sound_film(const std::filesystem::path& path, double seconds);

// Where the first sound track begins and ends, seconds from the film's start; nothing without one.
std::optional<std::pair<double, double>> sound_seconds(const std::filesystem::path& path);

}  // namespace posecoach
