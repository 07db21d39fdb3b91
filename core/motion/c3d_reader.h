// C3D: the binary exchange format of motion capture (www.c3d.org). Points only; analog samples are skipped.
#pragma once

#include <string_view>

#include "core/motion/marker_track.h"

namespace posecoach {

// Intel, DEC and MIPS numbers, integer and float points. `file_name` is for messages.
// Errors: Malformed with file and byte; Unsupported (over 4096 points); Incomplete (no points, no frames).
Result<MarkerTrack> read_c3d(std::string_view file_name, std::string_view bytes);

}  // namespace posecoach
