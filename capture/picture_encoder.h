// Compresses pictures one by one, without looking ahead: each picture goes in and comes out at once, so that
// a recording never holds back more than its newest picture.
#pragma once

#include <cstdint>
#include <memory>

#include "capture/v4l2/jpeg.h"
#include "core/base/error.h"
#include "core/image/frame.h"

namespace posecoach {

enum class FilmCodec { H264, Jpeg };

// What a container must know of a film's pictures.
struct FilmStream {
  FilmCodec codec = FilmCodec::Jpeg;
  int width = 0;
  int height = 0;
  double nominal_fps = 30;
  Bytes header;  // H.264's parameter sets
};

struct EncodedPicture {
  Bytes bytes;
  bool is_key = true;  // decodes without others
};

class PictureEncoder {
 public:
  virtual ~PictureEncoder() = default;
  virtual const FilmStream& stream() const = 0;
  // Pictures of another size are scaled. Errors: Internal.
  virtual Result<EncodedPicture> encode(const Image& image) = 0;
};

// Sizes become even. Errors: Unsupported (no H.264 encoder in this FFmpeg), InvalidArgument (size).
Result<std::unique_ptr<PictureEncoder>> make_picture_encoder(FilmCodec codec, int width, int height,
                                                             double nominal_fps);

}  // namespace posecoach
