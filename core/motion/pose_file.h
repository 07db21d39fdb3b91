// The ".pose.json" file, schema "posecoach.pose/1". Two kinds share it.
//
// What the pose stage saw in a film:
//   {"schema", "source", "width", "height", "joints": [33 names],
//    "frames": [{"index", "time_s", "found", "image": [[x_px, y_px, visibility], ...],
//                "world": [[x_m, y_m, z_m, visibility], ...]}]}
//   the landmarks in BlazePose's order; world hip-centred, +Y down, as the model gives it. A frame in which
//   nobody was found has found: false and neither image nor world.
//
// A motion, told by its field "skeleton": the body's joints as in a .body.json. Then "joints" are the body's,
//   "world" holds each joint relative to the root in the same axes (x, -y, -z of ours) with its confidence as
//   the fourth number, "root_m" is the root's place in our world (+Y up), and "rotations", where there are
//   any, are local, [w, x, y, z].
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/motion/motion.h"
#include "core/motion/pose_track.h"

namespace posecoach {

// `file_name` is for messages. Errors: Malformed with file and line; Incomplete (a motion without frames).
Result<std::variant<PoseTrack, Motion>> read_pose_json(std::string_view file_name, std::string_view text);
// Unsupported when the file holds a motion.
Result<PoseTrack> read_pose_track(const std::filesystem::path& path);

std::string pose_json_from_motion(const Motion& motion, std::string_view source);
std::string pose_json_from_track(const PoseTrack& track);

// Writes a track frame by frame, so that a long film takes no memory. Without finish() no file appears.
class PoseTrackWriter {
 public:
  // Errors: those of AtomicFile.
  static Result<PoseTrackWriter> create(const std::filesystem::path& path, std::string_view source, int width,
                                        int height);
  Result<void> add(const PoseObservation& observation);
  Result<void> finish();

 private:
  explicit PoseTrackWriter(AtomicFile file) : file_(std::move(file)) {}

  AtomicFile file_;
  bool is_first_ = true;
};

Result<void> write_pose_track(const std::filesystem::path& path, const PoseTrack& track);

}  // namespace posecoach
