// What another program saw in a film, to compare the pose stage with.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/pose_track.h"
#include "core/vision/pose_tracker.h"

namespace posecoach {

struct PoseReferenceFrame {
  std::size_t frame_index = 0;
  std::optional<SeenPerson> person;
};

struct PoseReference {
  std::string name;
  PoseTrackerOptions options;  // how the other program was set
  std::vector<PoseReferenceFrame> frames;
};

// { "model", "smoothing", "detector_every_frame", "frames": [{"frame", "width", "height", "landmarks": 33 x
// [x, y, z, visibility] with x and y in [0, 1], "world": 33 x [x, y, z, visibility] in metres}, ...] }; a
// frame without a person has no landmarks. Errors: Malformed, naming the file.
Result<PoseReference> read_pose_reference(const std::filesystem::path& file);

struct PoseAgreement {
  std::size_t frames = 0;      // that both have with a person
  std::size_t mismatched = 0;  // a person in the one and not in the other
  // Over frames: mean distance of the landmarks.
  double image_median_px = 0;
  double image_percentile95_px = 0;
  double image_max_px = 0;
  double world_median_mm = 0;
};

PoseAgreement compare_poses(const PoseTrack& track, const PoseReference& reference);

}  // namespace posecoach
