#include "app/window/live_session.h"

#include <utility>

#include "capture/open_source.h"
#include "capture/recorder.h"
#include "capture/simulated_source.h"
#include "capture/v4l2/camera_name.h"
#include "capture/v4l2/open_camera.h"

namespace posecoach {

struct LiveSession::Tape {
  std::unique_ptr<Recorder> recorder;
};

std::vector<FoundCamera> find_cameras(const CameraListOptions& cameras) {
  std::vector<FoundCamera> found;
  for (const CameraDescription& camera : list_cameras(cameras)) {
    std::string detail = camera.node.string();
    if (!camera.problem.empty())
      detail = camera.problem;
    else if (!camera.modes.empty())
      detail += ", up to " + std::to_string(camera.modes.front().width) + " × " +
                std::to_string(camera.modes.front().height);
    found.push_back({camera.source(), camera.name, detail, camera.modes});
  }
  return found;
}

Result<std::unique_ptr<LiveSession>> LiveSession::make(const PoseTrackerOptions& pose,
                                                       const LiveDevices& devices) {
  std::unique_ptr<PoseEstimator> eyes;
  if (devices.make_estimator) {
    eyes = devices.make_estimator();
  } else {
    Result<std::unique_ptr<PoseTracker>> tracker = PoseTracker::make(pose);
    if (!tracker) return tl::unexpected(tracker.error());
    eyes = *std::move(tracker);
  }
  std::unique_ptr<LiveSession> made(new LiveSession());
  made->runner_ = std::make_unique<PipelineRunner>(
      std::move(eyes),
      [cameras = devices.cameras](const std::string& name) -> Result<std::unique_ptr<FrameSource>> {
        if (!is_camera_name(name)) return open_source(name);
        Result<std::unique_ptr<V4l2Camera>> camera = open_camera(name, cameras);
        if (!camera) return tl::unexpected(camera.error());
        return std::unique_ptr<FrameSource>(*std::move(camera));
      });
  return made;
}

LiveSession::~LiveSession() {
  if (tape_) (void)stop_recording();
}

void LiveSession::set_source(const std::string& source) {
  runner_->set_source({source, is_simulated_source(source) ? AtEnd::Repeat : AtEnd::Stop});
}

Result<void> LiveSession::start_recording(const std::string& path) {
  if (tape_) return {};
  Result<std::unique_ptr<Recorder>> recorder = Recorder::start(path);
  if (!recorder) return tl::unexpected(recorder.error());
  tape_ = std::make_shared<Tape>(Tape{*std::move(recorder)});
  runner_->set_tap([tape = tape_](const Frame& frame) { (void)tape->recorder->offer(frame); });
  return {};
}

Result<std::string> LiveSession::stop_recording() {
  if (!tape_) return fail(ErrorCode::InvalidArgument, "nothing is being recorded");
  runner_->set_tap({});
  const std::shared_ptr<Tape> tape = std::exchange(tape_, nullptr);
  Result<RecorderStatus> status = tape->recorder->finish();
  if (!status) return tl::unexpected(status.error());
  return status->path.string();
}

SessionRecording LiveSession::recording() const {
  if (!tape_) return {};
  const RecorderStatus status = tape_->recorder->status();
  return {true, to_seconds(status.length), status.written, status.dropped,
          status.failure ? status.failure->message : std::string()};
}

}  // namespace posecoach
