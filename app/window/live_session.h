// The live pipeline with its camera and its recorder, as the window uses it.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "capture/v4l2/camera_list.h"
#include "core/pipeline/pipeline_runner.h"
#include "core/vision/pose_tracker.h"

namespace posecoach {

// A camera of this machine.
struct FoundCamera {
  std::string source, name, detail;
  std::vector<CameraMode> modes;
};
std::vector<FoundCamera> find_cameras(const CameraListOptions& cameras = {});

// What the program sees with. Tests put their own cameras and eyes in place of the machine's.
struct LiveDevices {
  CameraListOptions cameras = {};
  std::function<std::unique_ptr<PoseEstimator>()> make_estimator = {};  // empty: the pose networks
};

struct SessionRecording {
  bool is_on = false;
  double seconds = 0;
  std::uint64_t written = 0, lost = 0;
  std::string problem;  // why it ended by itself
};

class LiveSession {
 public:
  // Errors: the pose networks are missing.
  static Result<std::unique_ptr<LiveSession>> make(const PoseTrackerOptions& pose,
                                                   const LiveDevices& devices = {});
  ~LiveSession();

  PipelineRunner& runner() { return *runner_; }
  // A simulated student plays again and again; a film stops at its end.
  void set_source(const std::string& source);

  Result<void> start_recording(const std::string& path);
  // The film's path. Errors: those of the recorder.
  Result<std::string> stop_recording();
  SessionRecording recording() const;

 private:
  LiveSession() = default;
  struct Tape;
  std::shared_ptr<Tape> tape_;
  std::unique_ptr<PipelineRunner> runner_;
};

}  // namespace posecoach
