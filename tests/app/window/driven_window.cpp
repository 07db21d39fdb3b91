#include "tests/app/window/driven_window.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <thread>

#include "core/vision/detector.h"

namespace posecoach {
namespace {

class SeesNobody : public PoseEstimator {
 public:
  Result<PoseObservation> estimate(const Frame& frame) override {
    return PoseObservation{frame.index, frame.time, std::nullopt};
  }
  void reset() override {}
};

}  // namespace

WindowPlaces::WindowPlaces() {
  // The networks are where they were.
  if (const auto detector = find_model_file(kDetectorFileName, std::nullopt))
    ::setenv("POSECOACH_MODELS", detector->parent_path().c_str(), 1);
  for (const auto& [name, place] :
       {std::pair("XDG_CONFIG_HOME", "config"), std::pair("XDG_DATA_HOME", "data"),
        std::pair("XDG_STATE_HOME", "state"), std::pair("POSECOACH_LIBRARY", "swings")})
    ::setenv(name, folder(place).c_str(), 1);
}

bool has_pose_networks() {
  return find_model_file(kDetectorFileName, std::nullopt).has_value();
}

DrivenWindow::DrivenWindow(const LiveArguments& arguments, LiveDevices devices) {
  if (!devices.make_estimator) devices.make_estimator = [] { return std::make_unique<SeesNobody>(); };
  Result<std::unique_ptr<WindowProgram>> program = WindowProgram::make(arguments, std::move(devices));
  EXPECT_TRUE(program) << program.error().message;
  program_ = *std::move(program);
}

const WindowModel& DrivenWindow::look() {
  time_s_ += 0.05;
  return program_->model(time_s_, state_);
}

void DrivenWindow::press(Intent intent) {
  program_->perform({std::move(intent)}, state_);
}

const WindowModel& DrivenWindow::wait_until(const std::function<bool(const WindowModel&)>& happened) {
  while (true) {
    const WindowModel& model = look();
    if (happened(model)) return model;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

bool has_toast(const WindowModel& model, std::string_view words) {
  for (const Toast& toast : model.toasts)
    if (toast.text.find(words) != std::string::npos) return true;
  return false;
}

}  // namespace posecoach
