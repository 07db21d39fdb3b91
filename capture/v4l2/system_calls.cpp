#include "capture/v4l2/system_calls.h"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace posecoach {
namespace {

class RealSystemCalls : public V4l2SystemCalls {
 public:
  int open(const char* path, int flags) override { return ::open(path, flags); }
  int close(int descriptor) override { return ::close(descriptor); }
  int ioctl(int descriptor, unsigned long request, void* argument) override {
    return ::ioctl(descriptor, request, argument);
  }
  void* mmap(std::size_t length, int protection, int flags, int descriptor, off_t offset) override {
    return ::mmap(nullptr, length, protection, flags, descriptor, offset);
  }
  int munmap(void* address, std::size_t length) override { return ::munmap(address, length); }
  int poll(pollfd* descriptors, nfds_t count, int timeout_ms) override {
    return ::poll(descriptors, count, timeout_ms);
  }
};

}  // namespace

V4l2SystemCalls& real_v4l2_system_calls() {
  static RealSystemCalls calls;
  return calls;
}

}  // namespace posecoach
