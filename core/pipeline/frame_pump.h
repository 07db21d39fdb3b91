// The capture thread: opens the chosen source, takes its frames at their pace, and opens it again when it
// fails. Numbers and times of frames go on rising while the choice stays the same, whatever is reopened.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

#include "core/base/error.h"
#include "core/pipeline/coach_snapshot.h"
#include "core/pipeline/frame_source.h"

namespace posecoach {

// Opens a source by the name that the user gave it. Called on the capture thread.
using SourceOpener = std::function<Result<std::unique_ptr<FrameSource>>(const std::string& name)>;

enum class AtEnd {
  Stop,   // the state is Ended
  Repeat  // a demonstration plays again and again
};

struct SourceChoice {
  std::string name;
  AtEnd at_end = AtEnd::Stop;
};

struct PumpedFrame {
  Frame frame;
  std::uint64_t choice = 0;  // rises with every set_source
  // Rises with every opening: of a camera that was plugged in again, of a demonstration that plays again.
  std::uint64_t opening = 0;
  std::chrono::steady_clock::time_point arrived_at;  // capture where the source tells it, else hand-over
};

struct PumpStatus {
  std::uint64_t choice = 0;
  std::string source;
  SourceState state = SourceState::Opening;
  std::string message;  // why it is lost, or what was wrong with what has ended
  std::uint64_t captured = 0, lost_by_camera = 0;
  std::chrono::steady_clock::time_point last_frame_at;
};

struct FramePumpOptions {
  // Between attempts to open a lost source again: doubled each time.
  Duration first_retry = std::chrono::milliseconds(500), longest_retry = std::chrono::seconds(5);
};

class FramePump {
 public:
  // Every frame goes to the tap, then to `sink`, both on the capture thread.
  FramePump(SourceOpener open, std::function<void(PumpedFrame)> sink, FramePumpOptions options = {});
  ~FramePump();

  void set_source(SourceChoice choice);
  void set_tap(std::function<void(const Frame&)> tap);
  PumpStatus status() const;

 private:
  enum class PumpEnd { Stopped, EndOfStream, Failed };
  struct Continuation;

  void run(const std::stop_token& stop);
  void serve(const SourceChoice& choice, std::uint64_t number, const std::stop_token& stop);
  PumpEnd pump(FrameSource& source, Continuation& continuation, std::uint64_t number,
               const std::stop_token& stop, Error& error);
  void hand_over(Frame frame, std::uint64_t number, std::uint64_t opening);
  void set_state(SourceState state, std::string message = {});
  // Returns false when stopped meanwhile.
  bool sleep_until(std::chrono::steady_clock::time_point time, const std::stop_token& stop);

  SourceOpener open_;
  std::function<void(PumpedFrame)> sink_;
  FramePumpOptions options_;

  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::optional<SourceChoice> choice_;
  std::uint64_t choice_number_ = 0;
  std::stop_source choice_stop_;
  PumpStatus status_;

  std::mutex tap_mutex_;
  std::function<void(const Frame&)> tap_;

  std::jthread thread_;  // last: it uses all of the above
};

}  // namespace posecoach
