#include "app/evaluate/filmed_students.h"

#include "app/pose_options.h"
#include "core/motion/pose_file.h"
#include "core/pipeline/track_poses.h"

namespace posecoach {
namespace fs = std::filesystem;

SimulatedStudentOptions bench_film(std::string motion, Skeleton body, Handedness hand,
                                   const CameraPlace& camera, double frames_per_second) {
  SimulatedStudentOptions options;
  options.motion = std::move(motion);
  options.body = std::move(body);
  options.hand = hand;
  options.view = camera;
  options.frames_per_second = frames_per_second;
  options.width = 960;
  options.height = 540;
  return options;
}

FilmedStudents::FilmedStudents(fs::path folder, PoseTrackerOptions options)
    : folder_(std::move(folder)), options_(std::move(options)) {}

Result<FilmedStudents> FilmedStudents::make(const std::string& folder, PoseTrackerOptions options) {
  if (!folder.empty()) {
    std::error_code reason;
    fs::create_directories(folder, reason);
    if (reason)
      return fail(ErrorCode::Unreadable, "cannot make the folder " + folder + ": " + reason.message());
  }
  return FilmedStudents(folder, std::move(options));
}

Result<PoseTrack> FilmedStudents::track(const std::string& name, const SimulatedStudentOptions& film) {
  const fs::path file =
      folder_.empty() ? fs::path() : folder_ / (name + "-" + to_string(options_.model) + ".pose.json");
  std::error_code ignored;
  if (!file.empty() && fs::exists(file, ignored)) return read_pose_track(file);
  const auto student = SimulatedStudent::make(film);
  if (!student) return tl::unexpected(student.error());
  if (!tracker_) {
    auto made = PoseTracker::make(options_);
    if (!made) return tl::unexpected(made.error());
    tracker_ = *std::move(made);
  }
  tracker_->reset();
  Result<PoseTrack> track = track_poses(**student, *tracker_);
  if (track && !file.empty())
    if (const Result<void> written = write_pose_track(file, *track); !written)
      return tl::unexpected(written.error());
  return track;
}

}  // namespace posecoach
