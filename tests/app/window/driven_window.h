// The program behind the window without the window: looked at as each drawn frame does, told what a user
// wants.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "app/window/window_program.h"
#include "tests/support/temporary_folder.h"

namespace posecoach {

// Where the program keeps everything while a test runs; found again by every program started in it.
class WindowPlaces {
 public:
  WindowPlaces();
  std::filesystem::path library() const { return folder_.path() / "swings"; }
  std::filesystem::path folder(const std::string& name) const { return folder_.path() / name; }

 private:
  TemporaryFolder folder_;
};

bool has_pose_networks();

class DrivenWindow {
 public:
  // Without eyes of its own it sees nobody.
  explicit DrivenWindow(const LiveArguments& arguments, LiveDevices devices = {});

  WindowState& state() { return state_; }
  // One drawn frame. The window's clock goes ten times as fast as the frames are drawn here.
  const WindowModel& look();
  void press(Intent intent);
  // Draws until it has happened, as long as that takes: a machine may be slow, not wrong.
  const WindowModel& wait_until(const std::function<bool(const WindowModel&)>& happened);

 private:
  std::unique_ptr<WindowProgram> program_;
  WindowState state_;
  double time_s_ = 0;
};

bool has_toast(const WindowModel& model, std::string_view words);

}  // namespace posecoach
