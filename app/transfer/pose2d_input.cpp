#include "app/transfer/pose2d_input.h"

#include <charconv>
#include <filesystem>

#include "app/load_motion.h"
#include "capture/picture_folder.h"
#include "core/motion/motion_file.h"
#include "core/motion/openpose_reader.h"
#include "core/transfer/pose2d_sources.h"
#include "core/transfer/pose3d.h"

namespace posecoach {
namespace {

Result<std::vector<TimedPose2d>> from_track(const PoseTrack& track, const std::string& input) {
  std::vector<TimedPose2d> poses;
  for (const PoseObservation& seen : track.frames)
    if (seen.person)
      poses.push_back({seen.frame_index, to_seconds(seen.time), pose2d_from_landmarks(seen.person->image)});
  if (poses.empty()) return fail(ErrorCode::NoPerson, "nobody is seen in " + input);
  return poses;
}

Result<std::vector<TimedPose2d>> from_motion(const Motion& motion, double turn_degrees) {
  const Result<std::vector<Pose3d>> poses = poses_of(motion);
  if (!poses) return tl::unexpected(poses.error());
  std::vector<TimedPose2d> result;
  for (std::size_t i = 0; i < poses->size(); ++i)
    result.push_back({i, to_seconds(motion.time(static_cast<int>(i))),
                      project((*poses)[i], {radians_from_degrees(turn_degrees), 0})});
  return result;
}

Result<std::vector<TimedPose2d>> from_clip(const std::string& file, std::string_view number) {
  std::size_t clip = 0;
  const auto [end, problem] = std::from_chars(number.data(), number.data() + number.size(), clip);
  if (problem != std::errc() || end != number.data() + number.size())
    return fail(ErrorCode::InvalidArgument, "after '#' stands the number of a clip, as in " + file + "#0");
  const Result<std::vector<Pose2d>> poses = read_clip_poses(file, clip);
  if (!poses) return tl::unexpected(poses.error());
  std::vector<TimedPose2d> result;
  for (std::size_t i = 0; i < poses->size(); ++i) result.push_back({i, double(i), (*poses)[i]});
  return result;
}

Result<std::vector<TimedPose2d>> from_openpose(const std::string& folder) {
  const Result<ImageTrack> track = read_openpose_folder(folder);
  if (!track) return tl::unexpected(track.error());
  std::vector<TimedPose2d> poses;
  for (const ImageObservation& seen : track->frames)
    if (seen.person)
      poses.push_back({seen.frame_index, double(seen.frame_index), pose2d_from_landmarks(*seen.person)});
  if (poses.empty()) return fail(ErrorCode::NoPerson, "nobody is seen in " + folder);
  return poses;
}

// OpenPose's joints may lie beside the pictures that they were seen in; the pictures are worth more.
bool is_openpose(const std::string& input) {
  const Result<MotionFormat> format = motion_format(input);
  return format && *format == MotionFormat::OpenPoseFolder && !open_picture_folder(input);
}

// Everything else shows its people in pictures.
bool is_motion(const std::string& input) {
  if (input.starts_with("bundled:")) return true;
  const Result<MotionFormat> format = motion_format(input);
  return format && *format != MotionFormat::PoseTrack && *format != MotionFormat::OpenPoseFolder;
}

}  // namespace

Result<std::vector<TimedPose2d>> read_poses2d(const std::string& input, double turn_degrees,
                                              const PoseTrackerOptions& options, const Progress& progress) {
  if (!std::filesystem::exists(input))
    if (const std::size_t mark = input.rfind('#'); mark != std::string::npos)
      return from_clip(input.substr(0, mark), std::string_view(input).substr(mark + 1));
  LoadOptions load;
  load.pose = options;
  load.progress = progress;
  if (is_motion(input)) {
    const Result<LoadedMotion> loaded = load_motion(input, load);
    if (!loaded) return tl::unexpected(loaded.error());
    return from_motion(loaded->motion, turn_degrees);
  }
  if (is_openpose(input)) return from_openpose(input);
  const Result<PoseTrack> track = load_pose_track(input, load);
  if (!track) return tl::unexpected(track.error());
  return from_track(*track, input);
}

}  // namespace posecoach
