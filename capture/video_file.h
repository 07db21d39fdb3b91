// Films: anything that FFmpeg decodes, picture by picture, upright, with the film's own times.
#pragma once

#include <filesystem>
#include <memory>

#include "core/pipeline/frame_source.h"

namespace posecoach {

// Times count from the film's start (the earlier of its pictures and its sound), as the film states them: a
// variable frame rate stays variable. Memory does not grow with the film's length. A film that is damaged or
// cut off gives what can be decoded, then one warning in the log. Errors, now or from next(): NotFound,
// Unreadable, Malformed (no film, or nothing in it can be decoded), Unsupported (sound only, too large,
// unknown codec), Cancelled.
Result<std::unique_ptr<FrameSource>> open_video_file(const std::filesystem::path& path);

}  // namespace posecoach
