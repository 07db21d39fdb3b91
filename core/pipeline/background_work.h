// Work that takes longer than a frame, beside the steps of the pipeline, one piece after the other. Films and
// tests do it at once; live it has its own thread. The pieces are functions of values: when they run does not
// change what they answer.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace posecoach {

class BackgroundWork {
 public:
  virtual ~BackgroundWork() = default;
  virtual void start(std::function<void()> work) = 0;
};

// Done when start() returns.
class InlineWork : public BackgroundWork {
 public:
  void start(std::function<void()> work) override { work(); }
};

// In order, on one thread. The destructor waits for the piece at hand and drops the rest.
class ThreadedWork : public BackgroundWork {
 public:
  ThreadedWork();
  ~ThreadedWork() override;
  void start(std::function<void()> work) override;

 private:
  void run(const std::stop_token& stop);

  std::mutex mutex_;
  std::condition_variable_any arrived_;
  std::deque<std::function<void()>> waiting_;
  std::jthread thread_;  // last: it uses all of the above
};

// What a piece of work will answer. Dropped, the work goes on and nobody hears of it.
template <typename T>
class Pending {
 public:
  Pending() = default;
  Pending(BackgroundWork& work, std::function<T()> function) : slot_(std::make_shared<Slot>()) {
    work.start([slot = slot_, function = std::move(function)] {
      T answer = function();
      const std::lock_guard lock(slot->mutex);
      slot->answer.emplace(std::move(answer));
    });
  }

  bool is_waiting() const { return slot_ != nullptr; }
  // The answer, once, when it is there.
  std::optional<T> take() {
    if (!slot_) return std::nullopt;
    std::optional<T> answer;
    {
      const std::lock_guard lock(slot_->mutex);
      answer.swap(slot_->answer);
    }
    if (answer) slot_.reset();
    return answer;
  }

 private:
  struct Slot {
    std::mutex mutex;
    std::optional<T> answer;
  };
  std::shared_ptr<Slot> slot_;
};

}  // namespace posecoach
