// Recording goes before everything else: the simulated student numbers his pictures, a pose stage ten times
// too slow runs beside, and the film must hold every number.
#include <gtest/gtest.h>
#include <linux/videodev2.h>

#include <atomic>
#include <ctime>
#include <thread>

#include "capture/bar_code.h"
#include "capture/open_source.h"
#include "capture/recorder.h"
#include "capture/simulated_student.h"
#include "capture/v4l2/camera.h"
#include "core/pipeline/pipeline_runner.h"
#include "tests/capture/numbered_film.h"
#include "tests/support/fake_camera.h"
#include "tests/support/temporary_folder.h"

namespace posecoach {
namespace {

Duration time_of_this_thread() {
  timespec time = {};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

// Keeps a processor busy for ten times of what a picture may take; sees nobody. How long it has been busy is
// the time by which these tests count: where other programs take the processors, everything is later alike,
// and what is compared is the work of the threads, not the luck of the machine.
class SlowEstimator : public PoseEstimator {
 public:
  SlowEstimator(Duration one_picture, std::atomic<Duration>& busy) : one_picture_(one_picture), busy_(busy) {}

  Result<PoseObservation> estimate(const Frame&) override {
    const Duration before = time_of_this_thread(), busy_before = busy_;
    for (Duration since{0}; since < 10 * one_picture_; since = time_of_this_thread() - before)
      busy_ = busy_before + since;
    return PoseObservation{};
  }
  void reset() override {}

 private:
  Duration one_picture_;
  std::atomic<Duration>& busy_;
};

TEST(RecordingProof, every_picture_is_in_the_film_while_the_pose_stage_is_ten_times_too_slow) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "film.mkv";
  auto recorder = Recorder::start(path, {.nominal_fps = 30}).value();
  std::atomic<Duration> busy = Duration(0);
  std::atomic<std::size_t> frames = 0;
  std::uint64_t skipped = 0;
  std::size_t frames_then = 0;
  {
    PipelineRunner runner(std::make_unique<SlowEstimator>(std::chrono::milliseconds(33), busy), open_source);
    runner.set_tap([&](const Frame& frame) {
      ++frames;
      recorder->offer(frame);
    });
    runner.set_source({"simulated:putt?size=320x240&fps=30"});
    // What was skipped is told with the next pose, which may be long in coming on a busy machine.
    while (frames_then < 60 || (skipped <= frames_then / 2 && frames_then < 600)) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      skipped = runner.snapshot()->counters.skipped_by_pose;
      frames_then = frames;
    }
  }
  const auto status = recorder->finish();
  ASSERT_TRUE(status) << status.error().message;
  EXPECT_GT(skipped, frames_then / 2) << "the pose stage was not slow: nothing is proved";
  EXPECT_EQ(status->dropped, 0U);
  EXPECT_EQ(status->written, frames);
  const NumberedFilm film = read_numbered_film(path);
  ASSERT_EQ(film.numbers.size(), frames);
  for (std::size_t i = 0; i < frames; ++i) {
    EXPECT_EQ(film.numbers[i], i);
    EXPECT_NEAR(film.times_s[i], static_cast<double>(i) / 30, 0.0006);
  }
}

constexpr int kWidth = 1280, kHeight = 720;
constexpr double kRate = 60;

// The thread sanitizer makes the program several times slower than it is. There the sensor is as much slower:
// what is looked at are the hand-overs, not the speed.
#ifdef __SANITIZE_THREAD__
constexpr int kSlower = 8;
constexpr std::size_t kPictures = 60;
#else
constexpr int kSlower = 1;
constexpr std::size_t kPictures = 150;
#endif

// The simulated student's swing as a camera's JPEG pictures, numbered.
std::vector<Bytes> camera_pictures(std::size_t count) {
  SimulatedStudentOptions options;
  options.frames_per_second = kRate;
  const auto student = SimulatedStudent::make(options).value();
  constexpr int kDrawn = 12, kFirst = 60;
  std::vector<Image> drawn;
  for (int frame = 0; frame < kDrawn; ++frame) drawn.push_back(student->draw(kFirst + 5 * frame));
  JpegEncoder encoder;
  std::vector<Bytes> pictures;
  for (std::size_t number = 0; number < count; ++number) {
    Image& picture = drawn[number % kDrawn];
    write_bar_code(picture, static_cast<std::uint32_t>(number));
    pictures.push_back(encoder.encode(picture, 85));
  }
  return pictures;
}

struct CameraRecording {
  std::size_t lost_by_camera = 0;  // the program did not give the driver its buffers back in time
  std::uint64_t skipped_by_pose = 0;
  RecorderStatus status;
  NumberedFilm film;
};

// From a camera of 1280x720 at 60 pictures a second, through the driver's four buffers, into the film. The
// recorder's queue is small, so that what is behind shows within the film; `at_tap` happens to every picture
// on its way.
CameraRecording record_camera(std::size_t pictures, const std::function<void()>& at_tap) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "film.mkv", node = folder.path() / "video0";
  std::fclose(std::fopen(node.c_str(), "w"));
  std::atomic<Duration> busy = Duration(0);
  FakeCamera::Habits habits;
  habits.modes = {{V4L2_PIX_FMT_MJPEG, kWidth, kHeight, {kRate}}};
  FakeCamera driver(node, habits);
  const Duration interval = duration_from_seconds(kSlower / kRate);
  driver.look_with({camera_pictures(pictures), interval, [&busy] { return busy.load(); }});
  auto recorder =
      Recorder::start(path, {.nominal_fps = kRate, .most_queued_bytes = std::size_t{64} << 20}).value();
  CameraRecording result;
  {
    PipelineRunner runner(std::make_unique<SlowEstimator>(interval, busy),
                          [&driver](const std::string& name) -> Result<std::unique_ptr<FrameSource>> {
                            auto camera = V4l2Camera::open({.path = name, .system_calls = &driver});
                            if (!camera) return tl::unexpected(camera.error());
                            return *std::move(camera);
                          });
    runner.set_tap([&](const Frame& frame) {
      at_tap();
      recorder->offer(frame);
    });
    runner.set_source({node.string()});
    while (recorder->status().offered + driver.pictures_lost() < pictures)
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    result.skipped_by_pose = runner.snapshot()->counters.skipped_by_pose;
  }
  result.lost_by_camera = driver.pictures_lost();
  result.status = recorder->finish().value();
  result.film = read_numbered_film(path);
  return result;
}

TEST(RecordingProof, a_camera_of_720_lines_at_60_pictures_a_second_loses_none) {
  const CameraRecording recording = record_camera(kPictures, [] {});
  EXPECT_GT(recording.skipped_by_pose, kPictures / 2) << "the pose stage was not slow: nothing is proved";
  EXPECT_EQ(recording.lost_by_camera, 0U);
  EXPECT_EQ(recording.status.dropped, 0U);
  ASSERT_EQ(recording.film.numbers.size(), kPictures);
  for (std::size_t i = 0; i < kPictures; ++i) EXPECT_EQ(recording.film.numbers[i], i);
}

// The proof above can fail: where every picture waits for two on its way, the driver runs out of buffers.
TEST(RecordingProof, a_program_too_slow_for_the_camera_is_seen_to_lose_pictures) {
  constexpr std::size_t kFew = 60;
  const CameraRecording recording = record_camera(kFew, [] {
    const Duration before = time_of_this_thread();
    while (time_of_this_thread() - before < kSlower * std::chrono::milliseconds(34)) continue;
  });
  EXPECT_GT(recording.lost_by_camera, kFew / 8);
  EXPECT_EQ(recording.film.numbers.size(), kFew - recording.lost_by_camera);
}

}  // namespace
}  // namespace posecoach
