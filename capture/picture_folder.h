// A folder of pictures as a film.
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "core/pipeline/frame_source.h"

namespace posecoach {

struct PictureFolderOptions {
  // Pictures carry no times, so this is the one place where a rate makes them.
  double pictures_per_second = 30;
};

// PNG and JPEG files in their natural order (frame2 before frame10); other files are not looked at. Errors,
// now or from next(): NotFound, Incomplete (no pictures in it), Malformed (a damaged picture, or one of
// another size than the first), Cancelled.
Result<std::unique_ptr<FrameSource>> open_picture_folder(const std::filesystem::path& folder,
                                                         const PictureFolderOptions& options = {});

// Whether `a` comes before `b` when digits count as numbers.
bool comes_before(std::string_view a, std::string_view b);

}  // namespace posecoach
