// A camera's name as a source:
//
//   camera:/dev/video0?width=1280&height=720&fps=60&format=MJPG      /dev/video0      camera:
//
// The last is the first camera that works. A bare device needs no prefix.
#pragma once

#include <string>
#include <string_view>

#include "capture/v4l2/camera_list.h"
#include "core/base/error.h"

namespace posecoach {

struct CameraName {
  std::filesystem::path path;  // empty: any
  CameraWish wish;
};

bool is_camera_name(std::string_view name);

// Errors: InvalidArgument, naming the setting that is wrong.
Result<CameraName> parse_camera_name(const std::string& name);

// The same with the stable path of the device that it now means, so that it is found again after re-plugging.
// What is no camera's name, or names none that is there, comes back as it is.
std::string stable_camera_name(const std::string& name, const CameraListOptions& options = {});

}  // namespace posecoach
