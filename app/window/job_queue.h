// Long work beside the window, one piece after the other, with progress and cancellation. What it leads to
// happens on the window's thread.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "ui/screens/window_model.h"

namespace posecoach {

class JobQueue {
 public:
  using Finish = std::function<void()>;  // on the window's thread
  // On the work thread. Its error is told to `failed`.
  using Work = std::function<Result<Finish>(const Progress& progress)>;

  explicit JobQueue(std::function<void(const Error&)> failed);
  ~JobQueue();

  // `is_shown` false: short work that nobody needs to see.
  void start(std::string title, Work work, bool is_shown = true);
  void cancel(int id);
  bool is_busy() const;
  std::vector<Job> jobs() const;
  // Waits until everything that was started is done, however long that takes.
  void drain();
  // On the window's thread, once a frame. Whether anything was finished.
  bool finish_jobs();

 private:
  struct Piece;
  void run(const std::stop_token& stop);

  std::function<void(const Error&)> failed_;
  mutable std::mutex mutex_;
  std::condition_variable_any arrived_, idle_;
  int next_id_ = 1;
  std::deque<std::shared_ptr<Piece>> waiting_;
  std::shared_ptr<Piece> running_;
  std::vector<Finish> finished_;
  std::jthread thread_;  // last: it uses all of the above
};

}  // namespace posecoach
