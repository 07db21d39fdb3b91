// What every user of FFmpeg's libraries needs.
#pragma once

#include <string>

namespace posecoach {

// FFmpeg writes to standard error on its own; after this it does not.
void keep_ffmpeg_quiet();

// What one of its negative results means, in words.
std::string ffmpeg_reason(int error);

}  // namespace posecoach
