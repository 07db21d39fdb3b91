#include "capture/open_source.h"

#include "capture/picture_folder.h"
#include "capture/video_file.h"

namespace posecoach {

Result<std::unique_ptr<FrameSource>> open_source(const std::string& name) {
  std::error_code ignored;
  if (std::filesystem::is_directory(name, ignored)) return open_picture_folder(name);
  return open_video_file(name);
}

}  // namespace posecoach
