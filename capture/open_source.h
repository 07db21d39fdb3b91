// Any source of pictures, by the name that the user wrote.
#pragma once

#include <memory>
#include <string>

#include "core/pipeline/frame_source.h"

namespace posecoach {

// A film or a folder of pictures. Errors: those of the source.
Result<std::unique_ptr<FrameSource>> open_source(const std::string& name);

}  // namespace posecoach
