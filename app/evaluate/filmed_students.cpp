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

fs::path FilmedStudents::file(const std::string& name) const {
  return folder_.empty() ? fs::path() : folder_ / (name + "-" + to_string(options_.model) + ".pose.json");
}

Result<PoseTracker*> FilmedStudents::tracker() {
  if (!tracker_) {
    auto made = PoseTracker::make(options_);
    if (!made) return tl::unexpected(made.error());
    tracker_ = *std::move(made);
  }
  tracker_->reset();
  return tracker_.get();
}

Result<FilmedStudents::Looks> FilmedStudents::looks(const std::string& name,
                                                    const SimulatedStudentOptions& film) {
  const fs::path smoothed = file(name), unsmoothed = file(name + "-unsmoothed");
  std::error_code ignored;
  if (!smoothed.empty() && fs::exists(smoothed, ignored) && fs::exists(unsmoothed, ignored)) {
    Result<PoseTrack> one = read_pose_track(smoothed), other = read_pose_track(unsmoothed);
    if (!one) return tl::unexpected(one.error());
    if (!other) return tl::unexpected(other.error());
    return Looks{*std::move(one), *std::move(other)};
  }
  const auto student = SimulatedStudent::make(film);
  if (!student) return tl::unexpected(student.error());
  const Result<PoseTracker*> eye = tracker();
  if (!eye) return tl::unexpected(eye.error());
  const FrameSourceInfo& info = (*student)->info();
  Looks looks{{info.name, info.width, info.height, {}}, {info.name, info.width, info.height, {}}};
  const auto done = track_poses(**student, **eye, {}, [&](const PoseObservation& seen) -> Result<void> {
    looks.smoothed.frames.push_back(seen);
    looks.unsmoothed.frames.push_back({seen.frame_index, seen.time, (*eye)->unsmoothed()});
    return {};
  });
  if (!done) return tl::unexpected(done.error());
  if (smoothed.empty()) return looks;
  if (const Result<void> written = write_pose_track(smoothed, looks.smoothed); !written)
    return tl::unexpected(written.error());
  if (const Result<void> written = write_pose_track(unsmoothed, looks.unsmoothed); !written)
    return tl::unexpected(written.error());
  return looks;
}

Result<PoseTrack> FilmedStudents::track(const std::string& name, const SimulatedStudentOptions& film) {
  const fs::path kept = file(name);
  std::error_code ignored;
  if (!kept.empty() && fs::exists(kept, ignored)) return read_pose_track(kept);
  const auto student = SimulatedStudent::make(film);
  if (!student) return tl::unexpected(student.error());
  const Result<PoseTracker*> eye = tracker();
  if (!eye) return tl::unexpected(eye.error());
  Result<PoseTrack> track = track_poses(**student, **eye);
  if (track && !kept.empty())
    if (const Result<void> written = write_pose_track(kept, *track); !written)
      return tl::unexpected(written.error());
  return track;
}

}  // namespace posecoach
