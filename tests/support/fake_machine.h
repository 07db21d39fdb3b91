// A machine with several cameras that tests plug in and out: its folder of devices, with the links that a
// system keeps there, and the system calls that reach each.
#pragma once

#include <deque>
#include <map>

#include "capture/v4l2/camera_list.h"
#include "tests/support/fake_camera.h"

namespace posecoach {

class FakeMachine : public V4l2SystemCalls {
 public:
  explicit FakeMachine(std::filesystem::path device_folder);

  // Plugged in, at videoN; lives as long as the machine.
  FakeCamera& add(int number, const FakeCamera::Habits& habits);
  void unplug(FakeCamera& camera);
  void plug_in(FakeCamera& camera, int number);
  // How the camera is named wherever it is plugged in.
  std::filesystem::path stable_path(const FakeCamera& camera);
  CameraListOptions cameras() { return {folder_, this}; }

  int open(const char* path, int flags) override;
  int close(int descriptor) override;
  int ioctl(int descriptor, unsigned long request, void* argument) override;
  void* mmap(std::size_t length, int protection, int flags, int descriptor, off_t offset) override;
  int munmap(void* address, std::size_t length) override;
  int poll(pollfd* descriptors, nfds_t count, int timeout_ms) override;

 private:
  struct Plugged {
    Plugged(std::filesystem::path at, std::filesystem::path named, const FakeCamera::Habits& habits)
        : camera(at, habits), node(std::move(at)), link(std::move(named)) {}
    FakeCamera camera;
    std::filesystem::path node, link;
  };
  struct Open {
    FakeCamera* camera = nullptr;
    int descriptor = -1;  // the camera's own
  };
  Plugged& plugged(const FakeCamera& camera);
  Open open_at(int descriptor) const;

  std::filesystem::path folder_;
  mutable std::mutex mutex_;
  std::deque<Plugged> cameras_;
  std::map<int, Open> open_;
  std::map<void*, FakeCamera*> mapped_;
  int next_descriptor_ = 5000;
};

}  // namespace posecoach
