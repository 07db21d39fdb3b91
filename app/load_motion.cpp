#include "app/load_motion.h"

#include <filesystem>

#include "capture/open_source.h"
#include "capture/picture_folder.h"
#include "core/motion/bundled_motion.h"
#include "core/motion/motion_file.h"
#include "core/motion/pose_file.h"
#include "core/pipeline/track_poses.h"
#include "core/session/places.h"
#include "core/session/references.h"

namespace posecoach {
namespace {

constexpr std::string_view kBundled = "bundled:";
constexpr std::string_view kSimulated = "simulated:";

// Which of the ways to read a source is its own.
enum class SourceKind { Bundled, MotionFile, PoseFile, OpenPoseFolder, Film };

// Pictures are worth more than OpenPose's flat joints, which may lie beside them.
SourceKind kind_of_folder(const std::string& folder) {
  if (open_picture_folder(folder)) return SourceKind::Film;
  std::error_code failed;
  for (std::filesystem::directory_iterator entry(folder, failed), end; !failed && entry != end;
       entry.increment(failed))
    if (entry->path().extension() == ".json") return SourceKind::OpenPoseFolder;
  return SourceKind::Film;  // of nothing, which opening it will tell
}

// A user's own coach lies in a file; everything else is its own name.
Result<std::string> behind_reference(const std::string& source) {
  if (!source.starts_with(kReferencePrefix)) return source;
  Result<Reference> reference = References(find_places().references()).find(source);
  if (!reference) return tl::unexpected(reference.error());
  return reference->motion.string();
}

Result<SourceKind> kind_of(const std::string& source) {
  if (source.starts_with(kBundled)) return SourceKind::Bundled;
  if (source.starts_with(kSimulated)) return SourceKind::Film;
  const Result<MotionFormat> format = motion_format(source);
  if (!format) {
    // No motion: a film, a picture folder, or nothing that we know, which opening it as a film will tell.
    if (format.error().code == ErrorCode::Unsupported) return SourceKind::Film;
    return tl::unexpected(format.error());
  }
  switch (*format) {
    case MotionFormat::PoseTrack:
      return SourceKind::PoseFile;
    case MotionFormat::OpenPoseFolder:
      return kind_of_folder(source);
    default:
      return SourceKind::MotionFile;
  }
}

Result<PoseTrack> see_film(const std::string& source, const LoadOptions& options) {
  auto film = open_source(source);
  if (!film) return tl::unexpected(film.error());
  // A recorded film is mended and smoothed with what comes after each frame too (lift); the live filter's lag
  // would only shift the swing's events.
  PoseTrackerOptions pose = options.pose;
  pose.smoothing = Smoothing::Off;
  auto tracker = PoseTracker::make(pose);
  if (!tracker) return tl::unexpected(tracker.error());
  return track_poses(**film, **tracker, options.progress);
}

Result<PoseTrack> see(const std::string& source, SourceKind kind, const LoadOptions& options) {
  switch (kind) {
    case SourceKind::PoseFile:
      return read_pose_track(source);
    case SourceKind::Film:
      return see_film(source, options);
    case SourceKind::OpenPoseFolder:
      return fail(
          ErrorCode::Unsupported,
          source + ": OpenPose's joints are flat; a motion needs a film, a pose file or a motion file");
    case SourceKind::Bundled:
    case SourceKind::MotionFile:
      break;
  }
  return fail(ErrorCode::Unsupported, source + ": this is a motion, not the film of a person");
}

}  // namespace

Result<PoseTrack> load_pose_track(const std::string& source, const LoadOptions& options) {
  const Result<std::string> place = behind_reference(source);
  if (!place) return tl::unexpected(place.error());
  const auto kind = kind_of(*place);
  if (!kind) return tl::unexpected(kind.error());
  return see(*place, *kind, options);
}

Result<LoadedMotion> load_motion(const std::string& source, const LoadOptions& options) {
  const Result<std::string> place = behind_reference(source);
  if (!place) return tl::unexpected(place.error());
  const auto kind = kind_of(*place);
  if (!kind) return tl::unexpected(kind.error());
  if (*kind == SourceKind::Bundled) {
    Result<Motion> motion = bundled_motion(std::string_view(source).substr(kBundled.size()));
    if (!motion) return tl::unexpected(motion.error());
    return LoadedMotion{source, *std::move(motion), {}, {}, 0};
  }
  if (*kind == SourceKind::MotionFile) {
    Result<MotionFile> file = read_motion_file(*place);
    if (!file) return tl::unexpected(file.error());
    return LoadedMotion{source, std::move(file->motion), std::move(file->provenance), {}, 0};
  }
  Result<PoseTrack> track = see(source, *kind, options);
  if (!track) return tl::unexpected(track.error());
  track->source = source;
  Result<LiftedStudent> lifted = lift(*track, options.lift);
  if (!lifted) return tl::unexpected(lifted.error());
  Motion motion = lifted->motion;
  const int first_frame = lifted->first_frame;
  return LoadedMotion{
      source, std::move(motion), {}, SeenStudent{*std::move(track), *std::move(lifted)}, first_frame};
}

Result<SkeletonFile> load_body(const std::string& source, const LoadOptions& options) {
  const Result<std::string> place = behind_reference(source);
  if (!place) return tl::unexpected(place.error());
  const auto kind = kind_of(*place);
  if (!kind) return tl::unexpected(kind.error());
  if (*kind == SourceKind::MotionFile) return read_skeleton_file(*place);
  Result<LoadedMotion> loaded = load_motion(source, options);
  if (!loaded) return tl::unexpected(loaded.error());
  return SkeletonFile{loaded->motion.skeleton(), {}};
}

}  // namespace posecoach
