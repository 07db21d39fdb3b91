#include "app/window/job_queue.h"

#include <algorithm>
#include <utility>

namespace posecoach {

struct JobQueue::Piece {
  Job job;
  Work work;
  bool is_shown = true;
  std::atomic<bool> is_cancelled = false;
};

JobQueue::JobQueue(std::function<void(const Error&)> failed)
    : failed_(std::move(failed)), thread_([this](const std::stop_token& stop) { run(stop); }) {}

JobQueue::~JobQueue() {
  const std::lock_guard lock(mutex_);
  waiting_.clear();
  if (running_) running_->is_cancelled = true;
}

void JobQueue::start(std::string title, Work work, bool is_shown) {
  auto piece = std::make_shared<Piece>();
  piece->job.title = std::move(title);
  piece->job.stage = "waiting";
  piece->work = std::move(work);
  piece->is_shown = is_shown;
  const std::lock_guard lock(mutex_);
  piece->job.id = next_id_++;
  waiting_.push_back(std::move(piece));
  arrived_.notify_one();
}

void JobQueue::cancel(int id) {
  const std::lock_guard lock(mutex_);
  std::erase_if(waiting_, [&](const auto& piece) { return piece->job.id == id; });
  if (running_ && running_->job.id == id) running_->is_cancelled = true;
}

bool JobQueue::is_busy() const {
  const std::lock_guard lock(mutex_);
  return running_ != nullptr || !waiting_.empty() || !finished_.empty();
}

std::vector<Job> JobQueue::jobs() const {
  const std::lock_guard lock(mutex_);
  std::vector<Job> jobs;
  if (running_ && running_->is_shown) jobs.push_back(running_->job);
  for (const auto& piece : waiting_)
    if (piece->is_shown) jobs.push_back(piece->job);
  return jobs;
}

void JobQueue::drain() {
  std::unique_lock lock(mutex_);
  idle_.wait(lock, [&] { return running_ == nullptr && waiting_.empty(); });
}

bool JobQueue::finish_jobs() {
  std::vector<Finish> finished;
  {
    const std::lock_guard lock(mutex_);
    finished.swap(finished_);
  }
  for (const Finish& finish : finished)
    if (finish) finish();
  return !finished.empty();
}

void JobQueue::run(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (arrived_.wait(lock, stop, [&] { return !waiting_.empty(); }) && !stop.stop_requested()) {
    const std::shared_ptr<Piece> piece = waiting_.front();
    waiting_.pop_front();
    running_ = piece;
    lock.unlock();
    Result<Finish> done = piece->work([this, piece, &stop](std::string_view stage, double fraction) {
      const std::lock_guard inner(mutex_);
      piece->job.stage = stage;
      piece->job.fraction = fraction;
      return !piece->is_cancelled && !stop.stop_requested();
    });
    lock.lock();
    running_ = nullptr;
    if (done)
      finished_.push_back(*std::move(done));
    else if (done.error().code != ErrorCode::Cancelled)
      finished_.push_back([this, error = done.error()] { failed_(error); });
    idle_.notify_all();
  }
}

}  // namespace posecoach
