#include "core/pipeline/pipeline_runner.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "core/motion/bundled_motion.h"
#include "tests/support/filmed_golfer.h"

namespace posecoach {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

std::shared_ptr<const Image> small_picture() {
  static const auto picture = std::make_shared<const Image>(Image::black(64, 36));
  return picture;
}

// A camera of a thousand pictures a second that does what a script says.
class ScriptedCamera : public FrameSource {
 public:
  struct Script {
    std::size_t frames = 1'000'000;  // then the end
    std::size_t fails_after = 1'000'000;
    std::size_t hangs_after = 1'000'000;
    std::size_t gap_at = 1'000'000;  // where three numbers are missing
    std::string damage = {};
    bool is_film = false;  // without stamps of capture: taken at the pace of its times
    Duration period = 1ms;
  };
  explicit ScriptedCamera(const Script& script) : script_(script) {}

  const FrameSourceInfo& info() const override { return info_; }
  Result<std::optional<Frame>> next(std::stop_token stop) override {
    if (next_ >= script_.fails_after) return fail(ErrorCode::DeviceLost, "the camera is unplugged");
    while (next_ >= script_.hangs_after && !stop.stop_requested()) std::this_thread::sleep_for(1ms);
    if (next_ >= script_.frames || stop.stop_requested()) return std::optional<Frame>();
    std::optional<CaptureTime> captured_at;
    if (!script_.is_film) {
      std::this_thread::sleep_for(script_.period);
      captured_at = std::chrono::time_point_cast<Duration>(Clock::now());
    }
    const std::size_t index = next_ + (next_ >= script_.gap_at ? 3 : 0);
    const MediaTime time(script_.period * static_cast<Duration::rep>(next_));
    ++next_;
    return Frame{index, time, captured_at, small_picture()};
  }

  std::string damage() const override { return script_.damage; }

 private:
  Script script_;
  std::size_t next_ = 0;
  FrameSourceInfo info_{"camera", 64, 36, 30, {}};
};

SourceOpener opener_of(std::vector<ScriptedCamera::Script> scripts) {
  return [scripts = std::move(scripts), opened = std::make_shared<std::size_t>(0)](
             const std::string&) -> Result<std::unique_ptr<FrameSource>> {
    const std::size_t k = std::min((*opened)++, scripts.size() - 1);
    return std::make_unique<ScriptedCamera>(scripts[k]);
  };
}

class SlowEstimator : public PoseEstimator {
 public:
  explicit SlowEstimator(Duration time) : time_(time) {}
  Result<PoseObservation> estimate(const Frame& frame) override {
    std::this_thread::sleep_for(time_);
    return PoseObservation{frame.index, frame.time, std::nullopt};
  }
  void reset() override {}

 private:
  Duration time_;
};

class FailingEstimator : public PoseEstimator {
 public:
  Result<PoseObservation> estimate(const Frame&) override {
    return fail(ErrorCode::Internal, "the network failed");
  }
  void reset() override {}
};

std::unique_ptr<PoseEstimator> quick_estimator() {
  return std::make_unique<SlowEstimator>(0ms);
}

PipelineRunnerOptions quick_retries() {
  PipelineRunnerOptions options;
  options.pump.first_retry = 5ms;
  options.pump.longest_retry = 20ms;
  return options;
}

// Waits as long as it takes: a machine may be slow, not wrong.
std::shared_ptr<const CoachSnapshot> wait_until(const PipelineRunner& runner,
                                                const std::function<bool(const CoachSnapshot&)>& happened) {
  while (true) {
    std::shared_ptr<const CoachSnapshot> snapshot = runner.snapshot();
    if (happened(*snapshot)) return snapshot;
    std::this_thread::sleep_for(1ms);
  }
}

TEST(PipelineRunner, shows_frames_soon_after_a_source_is_chosen) {
  PipelineRunner runner(quick_estimator(), opener_of({{}}));
  ASSERT_TRUE(runner.snapshot());
  runner.set_source({"camera:1"});
  const auto snapshot = wait_until(runner, [](const CoachSnapshot& s) { return s.frame.has_value(); });
  EXPECT_EQ(snapshot->source, "camera:1");
  EXPECT_EQ(snapshot->source_state, SourceState::Live);
  EXPECT_TRUE(runner.newest_frame());
}

TEST(PipelineRunner, the_tap_sees_every_frame_while_the_pose_stage_skips) {
  PipelineRunner runner(std::make_unique<SlowEstimator>(20ms), opener_of({{.frames = 200}}));
  std::vector<std::size_t> seen;
  std::atomic<bool> is_done = false;
  runner.set_tap([&](const Frame& frame) {
    seen.push_back(frame.index);
    is_done = frame.index == 199;
  });
  runner.set_source({"camera"});
  const auto snapshot =
      wait_until(runner, [](const CoachSnapshot& s) { return s.source_state == SourceState::Ended; });
  runner.set_tap({});
  ASSERT_EQ(seen.size(), 200U);
  for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_EQ(seen[i], i);
  EXPECT_EQ(snapshot->counters.captured, 200U);
  EXPECT_GT(snapshot->counters.skipped_by_pose, 100U);
  EXPECT_EQ(snapshot->counters.lost_by_camera, 0U);
}

TEST(PipelineRunner, a_film_that_is_over_says_what_was_wrong_with_it) {
  PipelineRunner runner(quick_estimator(),
                        opener_of({{.frames = 5, .damage = "it is cut off"}, {.frames = 5}}));
  const auto is_over = [](const CoachSnapshot& s) { return s.source_state == SourceState::Ended; };
  runner.set_source({"short.mp4"});
  EXPECT_EQ(wait_until(runner, is_over)->source_message, "it is cut off");
  runner.set_source({"whole.mp4"});
  const auto whole =
      wait_until(runner, [&](const CoachSnapshot& s) { return is_over(s) && s.source == "whole.mp4"; });
  EXPECT_EQ(whole->source_message, "");
}

TEST(PipelineRunner, the_lag_of_a_slow_pose_stage_does_not_grow) {
  PipelineRunner runner(std::make_unique<SlowEstimator>(10ms), opener_of({{}}));
  runner.set_source({"camera"});
  std::vector<std::size_t> behind;
  std::uint64_t last = 0;
  while (behind.size() < 60) {
    const auto snapshot =
        wait_until(runner, [&](const CoachSnapshot& s) { return s.frame && s.number > last; });
    last = snapshot->number;
    behind.push_back(snapshot->counters.captured - snapshot->frame->index);
  }
  // In frames of the camera, not in time: a queue would grow by nine with each pose.
  const std::size_t late = *std::min_element(behind.end() - 20, behind.end());
  const std::size_t early = *std::min_element(behind.begin(), behind.begin() + 20);
  EXPECT_LT(late, early + 20);
}

TEST(PipelineRunner, missing_numbers_are_counted_as_lost_by_the_camera) {
  PipelineRunner runner(quick_estimator(), opener_of({{.frames = 50, .gap_at = 20}}));
  runner.set_source({"camera"});
  const auto snapshot =
      wait_until(runner, [](const CoachSnapshot& s) { return s.source_state == SourceState::Ended; });
  EXPECT_EQ(snapshot->counters.lost_by_camera, 3U);
}

TEST(PipelineRunner, an_unplugged_camera_is_lost_with_a_message_and_live_again_when_it_is_back) {
  PipelineRunner runner(quick_estimator(),
                        opener_of({{.fails_after = 30},
                                   {.fails_after = 0},
                                   {.fails_after = 0},
                                   {.fails_after = 0},
                                   {.fails_after = 0},
                                   {.fails_after = 0},
                                   {.fails_after = 0},
                                   {}}),
                        quick_retries());
  runner.set_source({"camera"});
  std::vector<MediaTime> times;
  runner.set_tap([&](const Frame& frame) { times.push_back(frame.time); });
  const auto lost =
      wait_until(runner, [](const CoachSnapshot& s) { return s.source_state == SourceState::Lost; });
  EXPECT_NE(lost->source_message.find("unplugged"), std::string::npos);
  const auto again = wait_until(runner, [](const CoachSnapshot& s) {
    return s.source_state == SourceState::Live && s.frame && s.frame->index > 60;
  });
  EXPECT_TRUE(again->source_message.empty());
  runner.set_tap({});
  EXPECT_TRUE(std::is_sorted(times.begin(), times.end())) << "time never goes back";
}

TEST(PipelineRunner, a_source_that_cannot_be_opened_says_why) {
  PipelineRunner runner(quick_estimator(), [](const std::string&) -> Result<std::unique_ptr<FrameSource>> {
    return fail(ErrorCode::NotFound, "there is no camera /dev/video7");
  });
  runner.set_source({"camera:/dev/video7"});
  const auto lost =
      wait_until(runner, [](const CoachSnapshot& s) { return s.source_state == SourceState::Lost; });
  EXPECT_EQ(lost->source_message, "there is no camera /dev/video7");
}

TEST(PipelineRunner, a_silent_camera_is_stalled) {
  PipelineRunner runner(quick_estimator(), opener_of({{.hangs_after = 10}}));
  runner.set_source({"camera"});
  const auto stalled =
      wait_until(runner, [](const CoachSnapshot& s) { return s.source_state == SourceState::Stalled; });
  EXPECT_FALSE(stalled->source_message.empty());
  EXPECT_FALSE(stalled->student);
}

TEST(PipelineRunner, sources_change_while_it_runs_even_when_the_old_one_hangs) {
  std::atomic<int> open = 0;
  PipelineRunner runner(quick_estimator(),
                        [&](const std::string& name) -> Result<std::unique_ptr<FrameSource>> {
                          ++open;
                          return std::make_unique<ScriptedCamera>(
                              ScriptedCamera::Script{.hangs_after = name == "hanging" ? 1U : 1'000'000U});
                        });
  for (int round = 0; round < 5; ++round)
    for (const std::string name : {"hanging", "working"}) {
      runner.set_source({name});
      const auto snapshot =
          wait_until(runner, [&](const CoachSnapshot& s) { return s.frame && s.source == name; });
      EXPECT_EQ(snapshot->frame->index < 1'000'000, true);
    }
  EXPECT_EQ(open, 10);
}

TEST(PipelineRunner, a_demonstration_plays_again_with_rising_numbers_and_times) {
  PipelineRunner runner(quick_estimator(), opener_of({{.frames = 10, .is_film = true}}));
  std::vector<Frame> frames;
  std::atomic<std::size_t> count = 0;
  runner.set_tap([&](const Frame& frame) {
    frames.push_back(frame);
    ++count;
  });
  runner.set_source({"simulated:swing", AtEnd::Repeat});
  while (count < 35) std::this_thread::sleep_for(1ms);
  runner.set_tap({});
  for (std::size_t i = 1; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i].index, i);
    EXPECT_GT(frames[i].time, frames[i - 1].time);
  }
}

TEST(PipelineRunner, films_come_at_their_own_pace) {
  PipelineRunner runner(quick_estimator(), opener_of({{.frames = 20, .is_film = true, .period = 10ms}}));
  const auto begin = Clock::now();
  runner.set_source({"film.mp4"});
  wait_until(runner, [](const CoachSnapshot& s) { return s.source_state == SourceState::Ended; });
  EXPECT_GE(Clock::now() - begin, 190ms);
}

TEST(PipelineRunner, a_pose_stage_that_fails_is_told_and_does_not_end_the_loop) {
  PipelineRunner runner(std::make_unique<FailingEstimator>(), opener_of({{}}));
  runner.set_source({"camera"});
  const auto snapshot =
      wait_until(runner, [](const CoachSnapshot& s) { return s.frame && s.frame->index > 5; });
  EXPECT_NE(snapshot->source_message.find("network failed"), std::string::npos);
}

TEST(PipelineRunner, requests_run_in_order_between_steps_even_without_a_source) {
  PipelineRunner runner(quick_estimator(), opener_of({{}}));
  std::vector<int> order;
  std::atomic<bool> is_done = false;
  for (int k = 0; k < 100; ++k) runner.request([&order, k](CoachPipeline&) { order.push_back(k); });
  runner.request([&](CoachPipeline&) { is_done = true; });
  while (!is_done) std::this_thread::sleep_for(1ms);
  ASSERT_EQ(order.size(), 100U);
  EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
}

TEST(PipelineRunner, starts_and_stops_a_hundred_times) {
  for (int round = 0; round < 100; ++round) {
    PipelineRunner runner(quick_estimator(), opener_of({{}}));
    runner.set_source({"camera"});
    if (round % 2 == 0) wait_until(runner, [](const CoachSnapshot& s) { return s.frame.has_value(); });
  }
}

TEST(PipelineRunner, a_coach_is_carried_over_beside_the_running_loop) {
  const auto film = std::make_shared<const GolferFilm>(
      film_golfer({.parts = {{GolferPart::Kind::Stand, 600}}}, face_on_camera()));
  PipelineRunner runner(std::make_unique<KnowingEstimator>(film), opener_of({{.period = 5ms}}));
  runner.set_source({"camera"});
  runner.request(
      [](CoachPipeline& pipeline) { pipeline.set_coach(bundled_motion("swing").value(), "swing"); });
  const auto with_ghost = wait_until(runner, [](const CoachSnapshot& s) { return s.ghost.has_value(); });
  EXPECT_TRUE(with_ghost->student);
}

}  // namespace
}  // namespace posecoach
