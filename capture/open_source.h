// Any source of pictures, by the name that the user wrote.
#pragma once

#include <memory>
#include <string>

#include "core/pipeline/frame_source.h"

namespace posecoach {

// A film, a folder of pictures, or the simulated student (simulated_source.h). Errors: those of the source;
// Unsupported for cameras.
Result<std::unique_ptr<FrameSource>> open_source(const std::string& name);

}  // namespace posecoach
