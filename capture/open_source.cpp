#include "capture/open_source.h"

#include <filesystem>

#include "capture/picture_folder.h"
#include "capture/simulated_source.h"
#include "capture/v4l2/camera.h"
#include "capture/v4l2/camera_name.h"
#include "capture/video_file.h"

namespace posecoach {
namespace {

Result<std::unique_ptr<FrameSource>> open_camera(const std::string& name) {
  // "camera:" alone becomes the first one that works.
  const Result<CameraName> wanted = parse_camera_name(stable_camera_name(name));
  if (!wanted) return tl::unexpected(wanted.error());
  if (wanted->path.empty())
    return fail(ErrorCode::NotFound,
                "no camera is connected that works (posecoach cameras); use simulated:swing or a film");
  Result<std::unique_ptr<V4l2Camera>> camera =
      V4l2Camera::open({.path = wanted->path, .name = name, .wish = wanted->wish});
  if (!camera) return tl::unexpected(camera.error());
  return std::unique_ptr<FrameSource>(*std::move(camera));
}

Result<std::unique_ptr<FrameSource>> open_simulated_student(const std::string& name) {
  const Result<SimulatedStudentOptions> options = simulated_student_from_source(name);
  if (!options) return tl::unexpected(options.error());
  Result<std::unique_ptr<SimulatedStudent>> student = SimulatedStudent::make(*options);
  if (!student) return tl::unexpected(student.error());
  return std::unique_ptr<FrameSource>(*std::move(student));
}

}  // namespace

Result<std::unique_ptr<FrameSource>> open_source(const std::string& name) {
  if (is_simulated_source(name)) return open_simulated_student(name);
  if (is_camera_name(name)) return open_camera(name);
  std::error_code ignored;
  if (std::filesystem::is_directory(name, ignored)) return open_picture_folder(name);
  return open_video_file(name);
}

}  // namespace posecoach
