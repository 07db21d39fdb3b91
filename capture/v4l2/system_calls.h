// The system calls that cameras are driven with, as an interface, so that tests can stand in for the driver.
#pragma once

#include <poll.h>
#include <sys/types.h>

#include <cstddef>

namespace posecoach {

// Each behaves as the call of its name: -1 (or MAP_FAILED) and errno on failure. One object may serve several
// devices and threads.
class V4l2SystemCalls {
 public:
  virtual ~V4l2SystemCalls() = default;
  virtual int open(const char* path, int flags) = 0;
  virtual int close(int descriptor) = 0;
  virtual int ioctl(int descriptor, unsigned long request, void* argument) = 0;
  virtual void* mmap(std::size_t length, int protection, int flags, int descriptor, off_t offset) = 0;
  virtual int munmap(void* address, std::size_t length) = 0;
  virtual int poll(pollfd* descriptors, nfds_t count, int timeout_ms) = 0;
};

V4l2SystemCalls& real_v4l2_system_calls();

}  // namespace posecoach
