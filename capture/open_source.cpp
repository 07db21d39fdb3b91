#include "capture/open_source.h"

#include <filesystem>

#include "capture/picture_folder.h"
#include "capture/simulated_source.h"
#include "capture/v4l2/camera_name.h"
#include "capture/v4l2/open_camera.h"
#include "capture/video_file.h"

namespace posecoach {
namespace {

// As the source that it is.
template <typename Source>
Result<std::unique_ptr<FrameSource>> as_source(Result<std::unique_ptr<Source>> opened) {
  if (!opened) return tl::unexpected(opened.error());
  return std::unique_ptr<FrameSource>(*std::move(opened));
}

Result<std::unique_ptr<FrameSource>> open_simulated_student(const std::string& name) {
  const Result<SimulatedStudentOptions> options = simulated_student_from_source(name);
  if (!options) return tl::unexpected(options.error());
  return as_source(SimulatedStudent::make(*options));
}

}  // namespace

Result<std::unique_ptr<FrameSource>> open_source(const std::string& name) {
  if (is_simulated_source(name)) return open_simulated_student(name);
  if (is_camera_name(name)) return as_source(open_camera(name));
  std::error_code ignored;
  if (std::filesystem::is_directory(name, ignored)) return open_picture_folder(name);
  return open_video_file(name);
}

}  // namespace posecoach
