#include "tests/support/fake_machine.h"

#include <sys/mman.h>

#include <algorithm>
#include <cerrno>
#include <fstream>

#include "core/base/assert.h"

namespace posecoach {
namespace fs = std::filesystem;

FakeMachine::FakeMachine(fs::path device_folder) : folder_(std::move(device_folder)) {
  fs::create_directories(folder_ / "v4l" / "by-id");
}

FakeCamera& FakeMachine::add(int number, const FakeCamera::Habits& habits) {
  const fs::path node = folder_ / ("video" + std::to_string(number));
  std::string id = "usb-" + habits.name + "-video-index0";
  std::replace(id.begin(), id.end(), ' ', '_');
  FakeCamera* camera = nullptr;
  {
    const std::scoped_lock lock(mutex_);
    cameras_.emplace_back(node, folder_ / "v4l" / "by-id" / id, habits);
    camera = &cameras_.back().camera;
  }
  plug_in(*camera, number);
  return *camera;
}

FakeMachine::Plugged& FakeMachine::plugged(const FakeCamera& camera) {
  const auto found =
      std::find_if(cameras_.begin(), cameras_.end(), [&](Plugged& one) { return &one.camera == &camera; });
  POSECOACH_ASSERT(found != cameras_.end());
  return *found;
}

void FakeMachine::unplug(FakeCamera& camera) {
  const std::scoped_lock lock(mutex_);
  const Plugged& one = plugged(camera);
  fs::remove(one.link);
  fs::remove(one.node);
  camera.unplug();
}

void FakeMachine::plug_in(FakeCamera& camera, int number) {
  const std::scoped_lock lock(mutex_);
  Plugged& one = plugged(camera);
  one.node = folder_ / ("video" + std::to_string(number));
  camera.plug_in_at(one.node);
  std::ofstream(one.node) << "";
  fs::create_symlink(one.node, one.link);
}

fs::path FakeMachine::stable_path(const FakeCamera& camera) {
  const std::scoped_lock lock(mutex_);
  return plugged(camera).link;
}

FakeMachine::Open FakeMachine::open_at(int descriptor) const {
  const std::scoped_lock lock(mutex_);
  const auto found = open_.find(descriptor);
  POSECOACH_ASSERT(found != open_.end());
  return found->second;
}

int FakeMachine::open(const char* path, int flags) {
  const std::scoped_lock lock(mutex_);
  std::error_code failed;
  const fs::path real = fs::weakly_canonical(path, failed);
  for (Plugged& one : cameras_) {
    if (fs::weakly_canonical(one.node, failed) != real) continue;
    const int descriptor = one.camera.open(path, flags);
    if (descriptor < 0) return -1;
    open_[next_descriptor_] = {&one.camera, descriptor};
    return next_descriptor_++;
  }
  errno = ENOENT;
  return -1;
}

int FakeMachine::close(int descriptor) {
  const Open open = open_at(descriptor);
  const std::scoped_lock lock(mutex_);
  open_.erase(descriptor);
  return open.camera->close(open.descriptor);
}

int FakeMachine::ioctl(int descriptor, unsigned long request, void* argument) {
  const Open open = open_at(descriptor);
  return open.camera->ioctl(open.descriptor, request, argument);
}

void* FakeMachine::mmap(std::size_t length, int protection, int flags, int descriptor, off_t offset) {
  const Open open = open_at(descriptor);
  void* const address = open.camera->mmap(length, protection, flags, open.descriptor, offset);
  const std::scoped_lock lock(mutex_);
  if (address != MAP_FAILED) mapped_[address] = open.camera;
  return address;
}

int FakeMachine::munmap(void* address, std::size_t length) {
  FakeCamera* camera = nullptr;
  {
    const std::scoped_lock lock(mutex_);
    const auto found = mapped_.find(address);
    POSECOACH_ASSERT(found != mapped_.end());
    camera = found->second;
    mapped_.erase(found);
  }
  return camera->munmap(address, length);
}

int FakeMachine::poll(pollfd* descriptors, nfds_t count, int timeout_ms) {
  POSECOACH_ASSERT(count == 1);
  const Open open = open_at(descriptors->fd);
  pollfd own = {open.descriptor, descriptors->events, 0};
  const int ready = open.camera->poll(&own, 1, timeout_ms);
  descriptors->revents = own.revents;
  return ready;
}

}  // namespace posecoach
