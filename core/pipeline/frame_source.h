// Where pictures come from: a camera, a film, a folder of pictures, the simulated student.
#pragma once

#include <optional>
#include <stop_token>
#include <string>

#include "core/base/error.h"
#include "core/image/frame.h"

namespace posecoach {

struct FrameSourceInfo {
  std::string name;  // as the user wrote it
  int width = 0;     // upright pixels
  int height = 0;
  double nominal_fps = 0;                  // for display; never for computing time
  std::optional<std::size_t> frame_count;  // an estimate where the container tells one
};

class FrameSource {
 public:
  virtual ~FrameSource() = default;
  virtual const FrameSourceInfo& info() const = 0;
  // The next picture; nothing at the end of the stream. Errors: a damaged file, a lost device.
  virtual Result<std::optional<Frame>> next(std::stop_token stop) = 0;
  // What was wrong with what has been read so far and what to do, in words for people; empty when all was
  // well.
  virtual std::string damage() const { return {}; }
};

}  // namespace posecoach
