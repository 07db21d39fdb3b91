// Sets the controls by which a test driver is told to misbehave.
#pragma once

#include <fcntl.h>
#include <linux/videodev2.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstring>

namespace posecoach {

class DriverControl {
 public:
  explicit DriverControl(const char* node) : descriptor_(::open(node, O_RDWR | O_CLOEXEC)) {}
  ~DriverControl() { ::close(descriptor_); }
  DriverControl(const DriverControl&) = delete;
  DriverControl& operator=(const DriverControl&) = delete;

  bool set(const char* name, int value) {
    v4l2_queryctrl query = {};
    for (query.id = V4L2_CTRL_FLAG_NEXT_CTRL; ::ioctl(descriptor_, VIDIOC_QUERYCTRL, &query) == 0;
         query.id |= V4L2_CTRL_FLAG_NEXT_CTRL) {
      if (std::strncmp(reinterpret_cast<const char*>(query.name), name, sizeof query.name - 1) != 0) continue;
      v4l2_control control = {query.id, value};
      return ::ioctl(descriptor_, VIDIOC_S_CTRL, &control) == 0;
    }
    return false;
  }

 private:
  int descriptor_ = -1;
};

}  // namespace posecoach
