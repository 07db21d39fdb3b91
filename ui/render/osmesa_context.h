// Off-screen OpenGL by OSMesa: software only, the same on every machine with the same Mesa.
#pragma once

#include <memory>

#include "ui/render/offscreen_context.h"

namespace posecoach {

// Current on the calling thread when it returns. Errors: Unsupported.
Result<std::unique_ptr<OffscreenContext>> make_osmesa_context();

}  // namespace posecoach
