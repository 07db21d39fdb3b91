// A camera by its name as a source (camera_name.h), as the live loop opens it.
#pragma once

#include <memory>
#include <string>

#include "capture/v4l2/camera.h"
#include "capture/v4l2/camera_list.h"

namespace posecoach {

// Errors: InvalidArgument (the name), NotFound (no camera works), those of V4l2Camera::open.
Result<std::unique_ptr<V4l2Camera>> open_camera(const std::string& name,
                                                const CameraListOptions& cameras = {});

}  // namespace posecoach
