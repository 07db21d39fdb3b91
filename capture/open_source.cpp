#include "capture/open_source.h"

#include <filesystem>

#include "capture/picture_folder.h"
#include "capture/simulated_source.h"
#include "capture/video_file.h"

namespace posecoach {
namespace {

bool is_camera(const std::string& name) {
  std::error_code ignored;
  return name.starts_with("camera:") || std::filesystem::is_character_file(name, ignored);
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
  if (is_camera(name))
    return fail(ErrorCode::Unsupported, name + ": cameras cannot be opened yet; record a film and use that");
  std::error_code ignored;
  if (std::filesystem::is_directory(name, ignored)) return open_picture_folder(name);
  return open_video_file(name);
}

}  // namespace posecoach
