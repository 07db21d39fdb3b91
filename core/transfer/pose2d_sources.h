// 2D poses from what detectors and data sets give.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/body/landmarks.h"
#include "core/transfer/pose2d.h"

namespace posecoach {

// Landmarks below this visibility count as not seen.
inline constexpr double kLeastVisibility = 0.5;
Pose2d pose2d_from_landmarks(const ImageKeypoints& landmarks);

// Clips of annotated people: {"joints": [15 names], "clips": [{"label", "frames": [[[x, y], ...], ...]}]}
// with neck, belly, face and the limbs of both sides. `clip` counts from 0. The face's centre is taken for
// the nose, the belly is not used. Errors: those of read_file; Malformed naming the file; InvalidArgument
// when there is no such clip.
Result<std::vector<Pose2d>> read_clip_poses(const std::filesystem::path& path, std::size_t clip);

}  // namespace posecoach
