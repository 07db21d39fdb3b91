// TRC: points over time as tab-separated text, read and written by OpenSim and most capture programs.
#pragma once

#include <string>
#include <string_view>

#include "core/motion/marker_track.h"

namespace posecoach {

// An empty cell is a hidden marker. `file_name` is for messages. Errors: Malformed with file and line;
// Unsupported (over 4096 markers).
Result<MarkerTrack> read_trc(std::string_view file_name, std::string_view text);

// The joints as markers, in metres, +Y up; joints of confidence 0 as empty cells. `file_name` stands in the
// header.
std::string trc_from_motion(std::string_view file_name, const Motion& motion);

}  // namespace posecoach
