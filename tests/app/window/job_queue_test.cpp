#include "app/window/job_queue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

namespace posecoach {
namespace {

TEST(JobQueue, stops_what_runs_and_what_waits_and_says_the_errors_of_the_rest) {
  std::vector<std::string> told;
  JobQueue queue([&](const Error& error) { told.push_back(error.message); });
  std::atomic<bool> has_begun = false;
  queue.start("endless", [&](const Progress& progress) -> Result<JobQueue::Finish> {
    for (int step = 0;; ++step) {
      has_begun = true;
      if (!report(progress, "turning", 0.001 * (step % 1000)))
        return fail(ErrorCode::Cancelled, "nobody needs to read this");
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  });
  bool has_waiting_run = false, has_last_finished = false;
  queue.start("waiting", [&](const Progress&) -> Result<JobQueue::Finish> {
    has_waiting_run = true;
    return JobQueue::Finish();
  });
  queue.start("failing", [](const Progress&) -> Result<JobQueue::Finish> {
    return fail(ErrorCode::Unreadable, "the disk is full");
  });
  queue.start("last", [&](const Progress&) -> Result<JobQueue::Finish> {
    return JobQueue::Finish([&] { has_last_finished = true; });
  });
  while (!has_begun) std::this_thread::yield();
  std::vector<Job> jobs = queue.jobs();
  ASSERT_EQ(jobs.size(), 4U);
  queue.cancel(jobs[1].id);
  queue.cancel(jobs[0].id);
  queue.drain();
  EXPECT_FALSE(has_last_finished) << "what work leads to happens on the window's thread";
  while (queue.finish_jobs()) continue;
  EXPECT_TRUE(has_last_finished);
  EXPECT_FALSE(has_waiting_run);
  EXPECT_THAT(told, testing::ElementsAre("the disk is full"));
  EXPECT_FALSE(queue.is_busy());
}

}  // namespace
}  // namespace posecoach
