// Between two threads where only the newest counts: one slot, newest wins, nothing grows. What was overtaken
// before anybody took it is counted, so that it can be shown. Any number of threads on both sides.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

#include "core/base/time.h"

namespace posecoach {

template <typename T>
class LatestValue {
 public:
  void put(T value) {
    // The old value dies after the lock: it may be a picture of megabytes.
    std::optional<T> old(std::move(value));
    {
      const std::lock_guard lock(mutex_);
      slot_.swap(old);
      if (old) ++overtaken_;
    }
    arrived_.notify_one();
  }

  // The newest value, taken out; nothing at once when there is none.
  std::optional<T> try_take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(slot_, std::nullopt);
  }

  // Waits for a value; nothing after `longest`, after wake(), and when stopped.
  std::optional<T> take(const std::stop_token& stop, Duration longest) {
    std::unique_lock lock(mutex_);
    arrived_.wait_for(lock, stop, longest, [this] { return slot_.has_value() || is_woken_; });
    is_woken_ = false;
    return std::exchange(slot_, std::nullopt);
  }

  // Ends the take() that waits, or the next one, although there is no value.
  void wake() {
    {
      const std::lock_guard lock(mutex_);
      is_woken_ = true;
    }
    arrived_.notify_one();
  }

  std::uint64_t overtaken() const {
    const std::lock_guard lock(mutex_);
    return overtaken_;
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable_any arrived_;
  std::optional<T> slot_;
  bool is_woken_ = false;
  std::uint64_t overtaken_ = 0;
};

}  // namespace posecoach
