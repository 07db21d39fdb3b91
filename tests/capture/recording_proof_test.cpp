// Recording goes before everything else: the simulated student numbers his pictures, a pose stage ten times
// too slow runs beside, and the film must hold every number.
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "capture/open_source.h"
#include "capture/recorder.h"
#include "core/pipeline/pipeline_runner.h"
#include "tests/capture/numbered_film.h"
#include "tests/support/temporary_folder.h"

namespace posecoach {
namespace {

using Clock = std::chrono::steady_clock;

// Keeps a processor busy for ten times of what a picture may take; sees nobody.
class SlowEstimator : public PoseEstimator {
 public:
  Result<PoseObservation> estimate(const Frame&) override {
    for (const auto end = Clock::now() + std::chrono::milliseconds(330); Clock::now() < end;) continue;
    return PoseObservation{};
  }
  void reset() override {}
};

TEST(RecordingProof, every_picture_is_in_the_film_while_the_pose_stage_is_ten_times_too_slow) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "film.mkv";
  auto recorder = Recorder::start(path, {.nominal_fps = 30}).value();
  std::atomic<std::size_t> frames = 0;
  std::uint64_t skipped = 0;
  {
    PipelineRunner runner(std::make_unique<SlowEstimator>(), open_source);
    runner.set_tap([&](const Frame& frame) {
      ++frames;
      recorder->offer(frame);
    });
    runner.set_source({"simulated:putt?size=320x240&fps=30"});
    while (frames < 60) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    skipped = runner.snapshot()->counters.skipped_by_pose;
  }
  const auto status = recorder->finish();
  ASSERT_TRUE(status) << status.error().message;
  EXPECT_GT(skipped, frames / 2) << "the pose stage was not slow: nothing is proved";
  EXPECT_EQ(status->dropped, 0U);
  EXPECT_EQ(status->written, frames);
  const NumberedFilm film = read_numbered_film(path);
  ASSERT_EQ(film.numbers.size(), frames);
  for (std::size_t i = 0; i < frames; ++i) {
    EXPECT_EQ(film.numbers[i], i);
    EXPECT_NEAR(film.times_s[i], static_cast<double>(i) / 30, 0.0006);
  }
}

}  // namespace
}  // namespace posecoach
