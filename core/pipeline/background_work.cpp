#include "core/pipeline/background_work.h"

#include "core/base/thread_name.h"

namespace posecoach {

ThreadedWork::ThreadedWork() : thread_([this](const std::stop_token& stop) { run(stop); }) {}

ThreadedWork::~ThreadedWork() {
  thread_.request_stop();
  thread_.join();
}

void ThreadedWork::start(std::function<void()> work) {
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(work));
  }
  arrived_.notify_one();
}

void ThreadedWork::run(const std::stop_token& stop) {
  name_this_thread("coach-work");
  while (true) {
    std::function<void()> work;
    {
      std::unique_lock lock(mutex_);
      if (!arrived_.wait(lock, stop, [this] { return !waiting_.empty(); }) || stop.stop_requested()) return;
      work = std::move(waiting_.front());
      waiting_.pop_front();
    }
    work();
  }
}

}  // namespace posecoach
