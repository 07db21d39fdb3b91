// The sound of one film on its way into another, packet by packet, without decoding.
#pragma once

#include <filesystem>
#include <memory>

#include "core/base/error.h"

struct AVFormatContext;

namespace posecoach {

class SoundTrack {
 public:
  // Adds a stream to `film`, before its header is written. Null when the file has no sound, or sound of a
  // kind that an MP4 cannot hold. Errors: NotFound, Unreadable, Malformed.
  static Result<std::unique_ptr<SoundTrack>> open(const std::filesystem::path& path, AVFormatContext& film);
  ~SoundTrack();

  // Writes the packets that begin before `seconds` of the new film; `later_s` is how much later a moment is
  // in the new film than in the old. Returns a negative FFmpeg result when writing fails.
  int copy_until(AVFormatContext& film, double seconds, double later_s);

 private:
  class Implementation;
  explicit SoundTrack(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace posecoach
