#include "capture/recorder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <thread>

#include "tests/capture/numbered_film.h"
#include "tests/support/temporary_folder.h"

namespace posecoach {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class RecorderTest : public testing::Test {
 protected:
  TemporaryFolder folder_;
  fs::path path_ = folder_.path() / "film.mkv";
};

TEST_F(RecorderTest, keeps_every_frame_its_number_and_its_own_time) {
  for (const RecorderCodec codec : {RecorderCodec::H264, RecorderCodec::Jpeg, RecorderCodec::Automatic}) {
    fs::remove(path_);
    auto recorder = Recorder::start(path_, {.codec = codec}).value();
    std::vector<double> times;
    for (std::size_t i = 0; i < 60; ++i) {
      times.push_back(0.5 + 0.033 * static_cast<double>(i) + (i % 3 == 1 ? 0.011 : 0.0));
      ASSERT_TRUE(recorder->offer(numbered_frame(640, 360, 100 + i, times.back())));
    }
    const auto status = recorder->finish();
    ASSERT_TRUE(status) << status.error().message;
    EXPECT_EQ(status->offered, 60U);
    EXPECT_EQ(status->written, 60U);
    EXPECT_EQ(status->dropped, 0U);
    EXPECT_EQ(status->bytes, fs::file_size(path_));
    const NumberedFilm film = read_numbered_film(path_);
    ASSERT_EQ(film.numbers.size(), 60U);
    for (std::size_t i = 0; i < 60; ++i) {
      EXPECT_EQ(film.numbers[i], 100 + i);
      EXPECT_NEAR(film.times_s[i], times[i] - times[0], 0.0006);
      EXPECT_EQ(recorder->frames()[i].index, 100 + i);
      EXPECT_NEAR(to_seconds(recorder->frames()[i].time), times[i] - times[0], 1e-9);
    }
  }
}

TEST_F(RecorderTest, a_film_without_frames_is_told_and_leaves_nothing) {
  auto recorder = Recorder::start(path_).value();
  const auto done = recorder->finish();
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::Incomplete);
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(RecorderTest, never_writes_over_a_film) {
  std::ofstream(path_) << "precious";
  const auto recorder = Recorder::start(path_);
  ASSERT_FALSE(recorder);
  EXPECT_EQ(recorder.error().code, ErrorCode::InvalidArgument);
  EXPECT_EQ(fs::file_size(path_), 8U);
}

TEST_F(RecorderTest, refuses_places_where_no_film_can_be) {
  EXPECT_EQ(Recorder::start(folder_.path() / "none" / "film.mkv").error().code, ErrorCode::NotFound);
  EXPECT_EQ(Recorder::start(folder_.path() / "film.mp4").error().code, ErrorCode::InvalidArgument);
  const auto full = Recorder::start(path_, {.reserved_disk_bytes = std::uint64_t{1} << 60});
  ASSERT_FALSE(full);
  EXPECT_EQ(full.error().code, ErrorCode::Unreadable);
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(RecorderTest, a_full_queue_drops_and_counts_and_the_film_goes_on) {
  // Room for two frames: some are taken, some are not, and all are accounted for.
  auto recorder =
      Recorder::start(path_, {.codec = RecorderCodec::H264, .most_queued_bytes = 2 * 640 * 360 * 3}).value();
  std::vector<std::size_t> taken;
  for (std::size_t i = 0; i < 200; ++i)
    if (recorder->offer(numbered_frame(640, 360, i, 0.01 * static_cast<double>(i)))) taken.push_back(i);
  const auto status = recorder->finish();
  ASSERT_TRUE(status);
  EXPECT_EQ(status->offered, 200U);
  EXPECT_EQ(status->written, taken.size());
  EXPECT_EQ(status->dropped, 200 - taken.size());
  EXPECT_LE(status->most_queued, 2U);
  const NumberedFilm film = read_numbered_film(path_);
  ASSERT_EQ(film.numbers.size(), taken.size());
  for (std::size_t i = 0; i < taken.size(); ++i) EXPECT_EQ(film.numbers[i], taken[i]);
}

TEST_F(RecorderTest, frames_of_another_size_are_scaled_to_the_films) {
  auto recorder = Recorder::start(path_).value();
  ASSERT_TRUE(recorder->offer(numbered_frame(640, 360, 1, 0)));
  ASSERT_TRUE(recorder->offer(numbered_frame(1280, 720, 2, 0.1)));
  ASSERT_TRUE(recorder->offer(numbered_frame(321, 241, 3, 0.2)));
  ASSERT_TRUE(recorder->finish());
  EXPECT_EQ(read_numbered_film(path_).numbers.size(), 3U);
  EXPECT_EQ(read_numbered_film(path_).numbers[1], 2U);
}

// The process that records is killed in the middle, at several moments of its clusters.
TEST_F(RecorderTest, killed_in_the_middle_the_film_opens_and_misses_at_most_the_last_second) {
  constexpr double kFps = 50;
  for (int round = 0; round < 4; ++round) {
    const fs::path path = folder_.path() / ("killed" + std::to_string(round) + ".mkv");
    int offered[2];
    ASSERT_EQ(::pipe(offered), 0);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      const auto codec = round % 2 == 0 ? RecorderCodec::Automatic : RecorderCodec::Jpeg;
      auto recorder = Recorder::start(path, {.nominal_fps = kFps, .codec = codec});
      if (!recorder) ::_exit(3);
      const auto start = std::chrono::steady_clock::now();
      for (std::uint32_t i = 0;; ++i) {
        std::this_thread::sleep_until(start + duration_from_seconds(i / kFps));
        (*recorder)->offer(numbered_frame(320, 240, i, i / kFps));
        if (::write(offered[1], &i, sizeof i) != sizeof i) ::_exit(4);
      }
    }
    ::close(offered[1]);
    std::uint32_t last = 0, number = 0;
    const auto kill_at = static_cast<std::uint32_t>(60 + 11 * round);
    while (last < kill_at && ::read(offered[0], &number, sizeof number) == sizeof number) last = number;
    ::kill(child, SIGKILL);
    while (::read(offered[0], &number, sizeof number) == sizeof number) last = number;
    ::close(offered[0]);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    const NumberedFilm film = read_numbered_film(path);
    ASSERT_GT(film.numbers.size(), 0U) << round;
    for (std::size_t i = 0; i < film.numbers.size(); ++i) ASSERT_EQ(film.numbers[i], i);
    EXPECT_LE(last - *film.numbers.back(), kFps) << round;
  }
}

// A limit on the size of files stands in for a full disk: the write fails in the middle either way.
TEST_F(RecorderTest, full_disk_ends_the_recording_with_a_message_and_keeps_what_was_written) {
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{600000, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &small);
  auto recorder = Recorder::start(path_, {.codec = RecorderCodec::Jpeg}).value();
  std::size_t number = 0;
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!recorder->status().failure && std::chrono::steady_clock::now() < deadline) {
    recorder->offer(numbered_frame(640, 360, number, static_cast<double>(number) / 30));
    ++number;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  const auto done = recorder->finish();
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_handler);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::Unreadable);
  EXPECT_THAT(done.error().message, HasSubstr("film.mkv"));
  EXPECT_THAT(done.error().message, HasSubstr("disk is full"));
  const NumberedFilm film = read_numbered_film(path_);
  ASSERT_GT(film.numbers.size(), 2U);
  for (std::size_t i = 0; i < film.numbers.size(); ++i) EXPECT_EQ(film.numbers[i], i);
}

TEST_F(RecorderTest, tells_what_fits_on_the_disk_even_of_a_folder_that_is_not_there_yet) {
  const auto room = recording_room(folder_.path() / "a" / "b", 1280, 720, 30);
  ASSERT_TRUE(room);
  EXPECT_GT(room->free_bytes, 0U);
  const auto faster = recording_room(folder_.path(), 1280, 720, 60);
  ASSERT_TRUE(faster);
  if (room->minutes < 1) GTEST_SKIP() << "the disk is nearly full";
  EXPECT_NEAR(room->minutes / faster->minutes, 2, 0.1);
}

}  // namespace
}  // namespace posecoach
