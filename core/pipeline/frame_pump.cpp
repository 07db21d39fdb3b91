#include "core/pipeline/frame_pump.h"

#include <algorithm>

#include "core/base/thread_name.h"

namespace posecoach {
namespace {

using Clock = std::chrono::steady_clock;

// A source slower than its own times is not chased after for longer than this.
constexpr Duration kMostBehind = std::chrono::milliseconds(250);

// Opening it again would not help: the file is broken, or the name is wrong.
bool is_final(const Error& error) {
  return error.code == ErrorCode::Malformed || error.code == ErrorCode::Unsupported ||
         error.code == ErrorCode::InvalidArgument;
}

}  // namespace

// What goes on over the reopening of a source.
struct FramePump::Continuation {
  std::uint64_t opening = 0;
  std::size_t index_offset = 0;
  Duration time_offset{0};
  std::optional<std::size_t> last_index;  // as handed over
  MediaTime last_time;
  Clock::time_point last_at;

  // The next opening's first frame follows the last one after the time that has really passed.
  void reopen(Duration at_least) {
    ++opening;
    if (!last_index) return;
    index_offset = *last_index + 1;
    time_offset = last_time.time_since_epoch() + std::max<Duration>(Clock::now() - last_at, at_least);
  }
};

FramePump::FramePump(SourceOpener open, std::function<void(PumpedFrame)> sink, FramePumpOptions options)
    : open_(std::move(open)),
      sink_(std::move(sink)),
      options_(options),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

FramePump::~FramePump() {
  thread_.request_stop();
  thread_.join();
}

void FramePump::set_source(SourceChoice choice) {
  std::stop_source old;
  {
    const std::lock_guard lock(mutex_);
    old = std::exchange(choice_stop_, std::stop_source());
    ++choice_number_;
    status_ = PumpStatus{};
    status_.choice = choice_number_;
    status_.source = choice.name;
    choice_ = std::move(choice);
  }
  old.request_stop();
  changed_.notify_all();
}

void FramePump::set_tap(std::function<void(const Frame&)> tap) {
  const std::lock_guard lock(tap_mutex_);
  tap_ = std::move(tap);
}

PumpStatus FramePump::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

void FramePump::set_state(SourceState state, std::string message) {
  const std::lock_guard lock(mutex_);
  // A choice made meanwhile has its own state.
  if (choice_stop_.stop_requested() || choice_) return;
  status_.state = state;
  status_.message = std::move(message);
}

bool FramePump::sleep_until(Clock::time_point time, const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  changed_.wait_until(lock, stop, time, [] { return false; });
  return !stop.stop_requested();
}

void FramePump::run(const std::stop_token& stop) {
  name_this_thread("coach-capture");
  while (!stop.stop_requested()) {
    SourceChoice choice;
    std::uint64_t number = 0;
    std::stop_source choice_stop;
    {
      std::unique_lock lock(mutex_);
      if (!changed_.wait(lock, stop, [this] { return choice_.has_value(); })) return;
      choice = *std::exchange(choice_, std::nullopt);
      number = choice_number_;
      choice_stop = choice_stop_;
    }
    const std::stop_callback stop_both(stop, [&] { choice_stop.request_stop(); });
    serve(choice, number, choice_stop.get_token());
  }
}

void FramePump::serve(const SourceChoice& choice, std::uint64_t number, const std::stop_token& stop) {
  Continuation continuation;
  Duration retry = options_.first_retry;
  while (!stop.stop_requested()) {
    Error error;
    std::string damage;
    PumpEnd end = PumpEnd::Failed;
    const auto frames_before = continuation.last_index;
    if (Result<std::unique_ptr<FrameSource>> source = open_(choice.name)) {
      end = pump(**source, continuation, number, stop, error);
      damage = (*source)->damage();
    } else {
      error = source.error();
    }
    const bool gave_frames = continuation.last_index != frames_before;
    if (end == PumpEnd::Stopped || stop.stop_requested()) return;
    if (end == PumpEnd::EndOfStream) {
      continuation.reopen(std::chrono::milliseconds(1));
      if (choice.at_end == AtEnd::Repeat && gave_frames) continue;
      set_state(SourceState::Ended, damage);
      sleep_until(Clock::time_point::max(), stop);
      return;
    }
    set_state(SourceState::Lost, error.message);
    if (is_final(error)) {
      sleep_until(Clock::time_point::max(), stop);
      return;
    }
    if (gave_frames) retry = options_.first_retry;
    if (!sleep_until(Clock::now() + retry, stop)) return;
    retry = std::min(2 * retry, options_.longest_retry);
    continuation.reopen(std::chrono::milliseconds(1));
  }
}

FramePump::PumpEnd FramePump::pump(FrameSource& source, Continuation& continuation, std::uint64_t number,
                                   const std::stop_token& stop, Error& error) {
  std::optional<MediaTime> first;
  Clock::time_point started_at;
  while (true) {
    Result<std::optional<Frame>> next = source.next(stop);
    if (stop.stop_requested()) return PumpEnd::Stopped;
    if (!next) {
      error = next.error();
      return PumpEnd::Failed;
    }
    if (!*next) return PumpEnd::EndOfStream;
    Frame frame = std::move(**next);
    if (!frame.captured_at) {
      if (!first) {
        first = frame.time;
        started_at = Clock::now();
      }
      const Clock::time_point due = started_at + (frame.time - *first);
      const Duration behind = Clock::now() - due;
      if (behind > kMostBehind) started_at += behind;
      if (behind < Duration(0) && !sleep_until(due, stop)) return PumpEnd::Stopped;
    }
    frame.index += continuation.index_offset;
    frame.time += continuation.time_offset;
    if (continuation.last_index && frame.index > *continuation.last_index + 1) {
      const std::lock_guard lock(mutex_);
      if (status_.choice == number) status_.lost_by_camera += frame.index - *continuation.last_index - 1;
    }
    continuation.last_index = frame.index;
    continuation.last_time = frame.time;
    continuation.last_at = Clock::now();
    hand_over(std::move(frame), number, continuation.opening);
  }
}

void FramePump::hand_over(Frame frame, std::uint64_t number, std::uint64_t opening) {
  const Clock::time_point now = Clock::now();
  {
    const std::lock_guard lock(tap_mutex_);
    if (tap_) tap_(frame);
  }
  {
    const std::lock_guard lock(mutex_);
    if (status_.choice == number) {
      ++status_.captured;
      status_.last_frame_at = now;
      status_.state = SourceState::Live;
      status_.message.clear();
    }
  }
  const auto arrived_at =
      frame.captured_at ? std::chrono::time_point_cast<Clock::duration>(*frame.captured_at) : now;
  sink_({std::move(frame), number, opening, arrived_at});
}

}  // namespace posecoach
