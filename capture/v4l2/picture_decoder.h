// From what a camera delivers to RGB.
#pragma once

#include <cstdint>
#include <span>

#include "capture/v4l2/device.h"
#include "capture/v4l2/jpeg.h"

namespace posecoach {

// MJPEG, YUYV, UYVY, NV12, RGB, BGR and grey.
bool can_decode(std::uint32_t pixel_format);

class PictureDecoder {
 public:
  explicit PictureDecoder(const AgreedFormat& format) : format_(format) {}

  // Error: Malformed (a picture cut short, a damaged JPEG). A JPEG has its own size.
  Result<Image> decode(std::span<const std::uint8_t> bytes);

 private:
  AgreedFormat format_;
  JpegDecoder jpeg_;
};

}  // namespace posecoach
