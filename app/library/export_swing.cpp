#include "app/library/export_swing.h"

#include "app/analyze/analyze_outputs.h"
#include "app/library/stored_swing.h"
#include "app/library/swing_block.h"
#include "core/base/file.h"
#include "core/body/body_file.h"
#include "core/motion/motion_file.h"
#include "core/motion/pose_file.h"
#include "core/retarget/rotation_recovery.h"
#include "core/session/disk.h"
#include "core/session/motion_table.h"

namespace posecoach {
namespace fs = std::filesystem;
namespace {

tl::unexpected<Error> has_no(const Swing& swing, const std::string& what) {
  return fail(ErrorCode::Incomplete, swing.id + ": it has no " + what);
}

// As it was kept: exporting changes nothing.
Result<void> copy_kept(const Swing& swing, std::string_view kind, const fs::path& file,
                       const Progress& progress) {
  const auto kept = swing.file(kind);
  if (!kept) return has_no(swing, std::string(kind));
  std::error_code failed;
  if (fs::equivalent(*kept, file, failed) && !failed)
    return fail(ErrorCode::InvalidArgument, file.string() + " is the library's own file; name another");
  const fs::path temporary = file.string() + ".part";
  fs::remove(temporary, failed);
  if (const Result<void> copied = copy_file(system_disk(), *kept, temporary, progress); !copied)
    return copied;
  fs::rename(temporary, file, failed);
  if (!failed) return {};
  const std::string reason = failed.message();
  fs::remove(temporary, failed);
  return fail(ErrorCode::Unreadable, "cannot write " + file.string() + ": " + reason);
}

Result<MotionFile> kept_motion(const Swing& swing) {
  const auto file = swing.file("student");
  if (!file) return has_no(swing, "motion yet; `library analyze` makes one");
  return read_motion_file(*file);
}

// Frames of an analysed film count as the film does.
int first_frame_of(const Swing& swing, const Motion& motion) {
  const auto file = swing.file("pose");
  const Result<PoseTrack> track =
      file ? read_pose_track(*file) : Result<PoseTrack>(fail(ErrorCode::NotFound, ""));
  if (!track) return 0;
  for (std::size_t frame = 0; frame < track->frames.size(); ++frame)
    if (track->frames[frame].time >= motion.time(0)) return static_cast<int>(frame);
  return 0;
}

Result<void> export_table(const Swing& swing, const fs::path& file) {
  const Result<MotionFile> motion = kept_motion(swing);
  if (!motion) return tl::unexpected(motion.error());
  return write_file_atomically(file, csv_from_motion(motion->motion, first_frame_of(swing, motion->motion)));
}

Result<void> export_picture_table(const Swing& swing, const fs::path& file) {
  const auto track_file = swing.file("pose");
  if (!track_file) return has_no(swing, "joints in the picture");
  const Result<PoseTrack> track = read_pose_track(*track_file);
  if (!track) return tl::unexpected(track.error());
  return write_file_atomically(file, csv_from_track(*track));
}

Result<void> export_motion(const Swing& swing, const fs::path& file) {
  const Result<MotionFile> motion = kept_motion(swing);
  if (!motion) return tl::unexpected(motion.error());
  // Only a BVH needs rotations; positions are closer to what was seen.
  const bool needs_rotations = file.string().ends_with(".bvh");
  return write_motion_file(file, needs_rotations ? with_rotations(motion->motion) : motion->motion,
                           motion->provenance);
}

Result<void> export_drawn(const Swing& swing, const AnalyzeOutputs& outputs, const ExportOptions& options) {
  const Result<StoredAnswer> answer = analyze_stored(swing, options.coach, options.load);
  if (!answer) return tl::unexpected(answer.error());
  return write_outputs(outputs, answer->student, answer->pair, options.load.progress);
}

}  // namespace

Result<void> export_swing(const Swing& swing, const fs::path& file, const ExportOptions& options) {
  const std::string name = file.filename().string();
  const Progress& progress = options.load.progress;
  if (name.ends_with(".picture.csv")) return export_picture_table(swing, file);
  if (name.ends_with(".csv")) return export_table(swing, file);
  if (name.ends_with(".bvh") || name.ends_with(".trc")) return export_motion(swing, file);
  if (name.ends_with(".pose.json"))
    return swing.file("pose") ? copy_kept(swing, "pose", file, progress) : export_motion(swing, file);
  if (name.ends_with(".body.json")) return copy_kept(swing, "student.body", file, progress);
  if (name.ends_with(".analysis.json")) return copy_kept(swing, "analysis", file, progress);
  AnalyzeOutputs outputs;
  outputs.palette = options.palette;
  if (options.has_drawings) {
    Result<Marks> marks = read_marks(swing);
    if (!marks) return tl::unexpected(marks.error());
    outputs.drawings = std::move(marks->drawings);
  }
  if (name.ends_with(".html")) outputs.report = file.string();
  if (!outputs.report.empty() && options.library != nullptr) {
    Result<Block> block = block_until(*options.library, swing);
    if (!block) return tl::unexpected(block.error());
    outputs.block = *std::move(block);
  }
  if (name.ends_with(".overlay.mp4")) outputs.video = file.string();
  if (!outputs.report.empty() || !outputs.video.empty()) return export_drawn(swing, outputs, options);
  const auto film = swing.file("film");
  if (film && file.extension() == film->extension()) return copy_kept(swing, "film", file, progress);
  return fail(ErrorCode::InvalidArgument,
              file.string() +
                  ": a swing is exported as .csv, .picture.csv, .bvh, .trc, .pose.json, "
                  ".body.json, .analysis.json, .html or .overlay.mp4" +
                  (film ? ", its film as " + film->extension().string() : ""));
}

Result<std::vector<fs::path>> export_everything(const Swing& swing, const fs::path& folder,
                                                const ExportOptions& options) {
  if (const Result<void> made = make_folders(system_disk(), folder); !made)
    return tl::unexpected(made.error());
  std::vector<std::string> endings;
  if (const auto film = swing.file("film")) endings.push_back(film->extension().string());
  if (swing.file("student")) endings.insert(endings.end(), {".csv", ".bvh", ".trc"});
  if (swing.file("pose")) endings.push_back(".picture.csv");
  if (swing.file("pose") || swing.file("student")) endings.push_back(".pose.json");
  if (swing.file("student.body")) endings.push_back(".body.json");
  if (swing.file("analysis")) endings.insert(endings.end(), {".analysis.json", ".html"});
  std::vector<fs::path> files;
  for (const std::string& ending : endings) {
    const fs::path file = folder / (swing.folder.filename().string() + ending);
    if (const Result<void> done = export_swing(swing, file, options); !done)
      return tl::unexpected(done.error());
    files.push_back(file);
  }
  return files;
}

}  // namespace posecoach
