// An OpenGL 3.3 core context without a window, for drawing into pictures. Two makes of it, each in its own
// target, because the libraries behind them cannot serve one process together: EGL (program) and OSMesa
// (tests).
#pragma once

#include <string>

#include "core/base/error.h"

namespace posecoach {

class OffscreenContext {
 public:
  virtual ~OffscreenContext() = default;
  // For the calling thread; a context is current on one thread at a time.
  virtual Result<void> make_current() = 0;
  // Who draws: "llvmpipe (LLVM 15.0.6, 256 bits)".
  virtual std::string renderer_name() const = 0;
};

}  // namespace posecoach
