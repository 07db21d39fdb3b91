// Motion files of every kind, in and out. A file is told by its contents, not by its name; a renamed one is
// read all the same.
//
//   BVH, ASF/AMC (the ASF beside the AMC: "01.asf" for "01_02.amc", or the only one in the folder),
//   C3D and TRC (markers become joints), .pose.json (ours)
//
// A .pose.json of a film (MotionFormat::PoseTrack, pose_file.h) and a folder of OpenPose JSON
// (MotionFormat::OpenPoseFolder, openpose_reader.h) are landmarks, not a motion: ask motion_format first.
#pragma once

#include <filesystem>

#include "core/motion/provenance.h"

namespace posecoach {

struct MotionReadOptions {
  // AMC files do not say their rate. CMU's were taken at 120.
  double amc_frames_per_second = 120;
};

// Reads no more than it must: films and folders of pictures may be asked, and are Unsupported.
// Errors: NotFound, Unreadable, Unsupported (none of the known kinds; the message lists them), Malformed.
Result<MotionFormat> motion_format(const std::filesystem::path& path);

// Every error is one line that names the file and the line (text) or byte (binary).
// Errors: those of motion_format; Malformed; Incomplete (no frames, no body); Unsupported (landmarks without
// a 3D motion).
Result<MotionFile> read_motion_file(const std::filesystem::path& path, const MotionReadOptions& options = {});

// The body alone: of any motion file, also one without frames, of an .asf or of a .body.json.
Result<SkeletonFile> read_skeleton_file(const std::filesystem::path& path,
                                        const MotionReadOptions& options = {});

// Whether the end of the name tells a kind that can be written: .bvh, .trc or .pose.json.
// Errors: InvalidArgument.
Result<void> check_motion_file_name(const std::filesystem::path& path);

// The kind is told by the end of the name. With the provenance of the file that the
// motion's skeleton came from, a BVH gets its joints, names, channels, rest pose, axes and units.
// Errors: InvalidArgument (another ending), Unsupported (a BVH without rotations), Unreadable.
Result<void> write_motion_file(const std::filesystem::path& path, const Motion& motion,
                               const MotionProvenance& provenance = {});

}  // namespace posecoach
