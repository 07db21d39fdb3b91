// From a decoded film frame of any pixel format to an upright RGB picture with square pixels.
#pragma once

#include "capture/ffmpeg.h"
#include "capture/orientation.h"
#include "core/base/error.h"

namespace posecoach {

class FilmPictureMaker {
 public:
  explicit FilmPictureMaker(Orientation orientation) : orientation_(orientation) {}

  // All pictures have the size of the first, whatever the film does. Error: Unsupported.
  Result<Image> make(const AVFrame& frame);

 private:
  Orientation orientation_;
  int width_ = 0;  // before it is turned upright
  int height_ = 0;
  FfmpegPointer<SwsContext> context_;
  std::vector<std::uint8_t> rows_;
};

}  // namespace posecoach
