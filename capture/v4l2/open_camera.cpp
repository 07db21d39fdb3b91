#include "capture/v4l2/open_camera.h"

#include "capture/v4l2/camera_name.h"

namespace posecoach {

Result<std::unique_ptr<V4l2Camera>> open_camera(const std::string& name, const CameraListOptions& cameras) {
  // "camera:" alone becomes the first one that works.
  const Result<CameraName> wanted = parse_camera_name(stable_camera_name(name, cameras));
  if (!wanted) return tl::unexpected(wanted.error());
  if (wanted->path.empty())
    return fail(ErrorCode::NotFound,
                "no camera is connected that works (posecoach cameras); use simulated:swing or a film");
  return V4l2Camera::open(
      {.path = wanted->path, .name = name, .wish = wanted->wish, .system_calls = cameras.system_calls});
}

}  // namespace posecoach
