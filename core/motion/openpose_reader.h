// A folder of OpenPose JSON, one file a frame, BODY_25. It has 2D joints only: good for drawing a pose over
// its pictures and for what is measured in the picture plane; there is no 3D motion in it, so it cannot be
// retargeted or compared in space.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/body/landmarks.h"

namespace posecoach {

// One frame's joints in the picture, as far as OpenPose knows BlazePose's landmarks (nose, eyes, ears,
// shoulders to wrists, hips to ankles, heels, big toes); the others have visibility 0.
struct ImageObservation {
  std::size_t frame_index = 0;
  std::optional<ImageKeypoints> person;
};

struct ImageTrack {
  std::string source;
  std::vector<ImageObservation> frames;  // in the order of the files' names
};

// The people of one file. Errors: Malformed with file and line; Unsupported (other models than BODY_25).
Result<std::vector<ImageKeypoints>> read_openpose_json(std::string_view file_name, std::string_view text);

// Files that end in .json, by name; the frame's number is the last number in the name, where there is one. Of
// several people the most confident one is followed. Errors: those of read_openpose_json; NotFound,
// Incomplete (no .json in the folder).
Result<ImageTrack> read_openpose_folder(const std::filesystem::path& folder);

}  // namespace posecoach
