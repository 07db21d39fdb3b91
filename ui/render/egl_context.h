// Off-screen OpenGL by EGL without a surface: needs no display, uses the graphics card where there is one and
// Mesa's software renderer where not.
#pragma once

#include <memory>

#include "ui/render/offscreen_context.h"

namespace posecoach {

// Current on the calling thread when it returns. Errors: Unsupported with what is missing.
Result<std::unique_ptr<OffscreenContext>> make_egl_context();

}  // namespace posecoach
