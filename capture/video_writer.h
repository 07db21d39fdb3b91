// An MP4 film (H.264) from pictures with their own times, with the sound of another film if wanted.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "core/base/error.h"
#include "core/base/time.h"
#include "core/image/frame.h"

namespace posecoach {

struct VideoWriterOptions {
  int width = 0;  // of the pictures; an odd size is padded by one row or column
  int height = 0;
  double nominal_fps = 30;  // how long the last picture stays; everybody else's time is his own
  int quality = 18;         // x264's constant rate factor: 0 is lossless, 51 the worst
  // A film whose first sound track is copied as it is, in time with the pictures, and cut to their length. A
  // film without sound is no error.
  std::optional<std::filesystem::path> sound_from = {};
};

// Written beside the destination and renamed by finish(): until then, and after any error, there is no new
// file at the path. Errors: InvalidArgument (a device or a pipe, sizes, times that do not increase), NotFound
// or Unreadable (folder, permission, disk full), Unsupported (no H.264 encoder in this FFmpeg), Internal.
class VideoWriter {
 public:
  static Result<std::unique_ptr<VideoWriter>> open(const std::filesystem::path& path,
                                                   const VideoWriterOptions& options);
  // Without finish(): removes what was written.
  ~VideoWriter();

  // Times strictly increase; the first picture is the film's start whatever its time, unless sound is copied:
  // then times are those of the sound's film.
  Result<void> write(const Image& picture, MediaTime time);
  Result<void> finish();

 private:
  class Implementation;
  explicit VideoWriter(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace posecoach
