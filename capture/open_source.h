// Any source of pictures, by the name that the user wrote.
#pragma once

#include <memory>
#include <string>

#include "core/pipeline/frame_source.h"

namespace posecoach {

// A camera (v4l2/camera_name.h), a film, a folder of pictures, or the simulated student (simulated_source.h).
// Errors: those of the source. Who opens a camera again later asks stable_camera_name() for its name first.
Result<std::unique_ptr<FrameSource>> open_source(const std::string& name);

}  // namespace posecoach
