#include "capture/frame_ring.h"

#include <gtest/gtest.h>

#include <thread>

#include "capture/bar_code.h"
#include "tests/capture/numbered_film.h"
#include "tests/support/temporary_folder.h"

namespace posecoach {
namespace {

namespace fs = std::filesystem;

std::vector<std::size_t> indices(const std::vector<CompressedFrame>& frames) {
  std::vector<std::size_t> all;
  for (const CompressedFrame& frame : frames) all.push_back(frame.index);
  return all;
}

std::vector<CompressedFrame> everything(const FrameRing& ring) {
  return ring.frames_between(MediaTime::min(), MediaTime::max());
}

TEST(FrameRing, keeps_the_last_frames_within_both_bounds) {
  FrameRing by_time({.longest = std::chrono::milliseconds(500)});
  for (std::size_t i = 0; i < 100; ++i)
    by_time.push(numbered_frame(320, 240, i, 0.1 * static_cast<double>(i)));
  EXPECT_EQ(indices(everything(by_time)), (std::vector<std::size_t>{94, 95, 96, 97, 98, 99}));
  EXPECT_NEAR(to_seconds(by_time.held().length), 0.5, 1e-9);

  const std::size_t one = everything(by_time).front().jpeg->size();
  FrameRing by_size({.most_bytes = 5 * one});
  for (std::size_t i = 0; i < 100; ++i) {
    by_size.push(numbered_frame(320, 240, i, 0.1 * static_cast<double>(i)));
    EXPECT_LE(by_size.held().bytes, 5 * one);
  }
  EXPECT_GE(by_size.held().frames, 4U);
  EXPECT_EQ(everything(by_size).back().index, 99U);
}

TEST(FrameRing, gives_the_frames_of_a_stretch_of_time) {
  FrameRing ring;
  for (std::size_t i = 0; i < 10; ++i) ring.push(numbered_frame(320, 240, i, 0.25 * static_cast<double>(i)));
  EXPECT_EQ(indices(ring.frames_between(media_time_from_seconds(0.5), media_time_from_seconds(1.1))),
            (std::vector<std::size_t>{2, 3, 4}));
  EXPECT_TRUE(ring.frames_between(media_time_from_seconds(9), media_time_from_seconds(10)).empty());
}

TEST(FrameRing, time_that_goes_back_starts_anew) {
  FrameRing ring;
  ring.push(numbered_frame(320, 240, 7, 3));
  ring.push(numbered_frame(320, 240, 0, 0));
  EXPECT_EQ(indices(everything(ring)), (std::vector<std::size_t>{0}));
  EXPECT_EQ(ring.held().bytes, everything(ring).front().jpeg->size());
}

TEST(FrameRing, pictures_come_back_nearly_as_they_were) {
  FrameRing ring;
  const Frame frame = numbered_frame(640, 360, 4711, 0);
  ring.push(frame);
  const Image image = decompressed(everything(ring).front()).value();
  ASSERT_EQ(image.width, 640);
  EXPECT_EQ(read_bar_code(image), 4711U);
  for (int y = 100; y < 360; y += 20)
    for (int x = 0; x < 640; x += 20)
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(image.pixel(x, y)[c], frame.image->pixel(x, y)[c], 6);
}

class ClipTest : public testing::Test {
 protected:
  std::vector<CompressedFrame> frames(std::size_t count) {
    FrameRing ring;
    for (std::size_t i = 0; i < count; ++i)
      ring.push(numbered_frame(640, 360, 50 + i, 2 + 0.02 * static_cast<double>(i) + (i > 5 ? 0.1 : 0.0)));
    return everything(ring);
  }
  TemporaryFolder folder_;
  fs::path path_ = folder_.path() / "clip.mkv";
};

TEST_F(ClipTest, holds_every_frame_with_its_own_time) {
  for (const ClipCodec codec : {ClipCodec::H264, ClipCodec::Jpeg}) {
    ASSERT_TRUE(write_clip(frames(30), path_, codec));
    const NumberedFilm film = read_numbered_film(path_);
    ASSERT_EQ(film.numbers.size(), 30U);
    for (std::size_t i = 0; i < 30; ++i) {
      EXPECT_EQ(film.numbers[i], 50 + i);
      EXPECT_NEAR(film.times_s[i], 0.02 * static_cast<double>(i) + (i > 5 ? 0.1 : 0.0), 0.0006);
    }
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 1);
}

TEST_F(ClipTest, refuses_what_is_no_clip_and_leaves_nothing) {
  EXPECT_EQ(write_clip({}, path_).error().code, ErrorCode::Incomplete);
  EXPECT_EQ(write_clip(frames(3), folder_.path() / "clip.avi").error().code, ErrorCode::InvalidArgument);
  EXPECT_EQ(write_clip(frames(3), folder_.path() / "none" / "clip.mkv").error().code, ErrorCode::NotFound);
  auto twice = frames(3);
  twice[2].time = twice[1].time;
  EXPECT_EQ(write_clip(twice, path_).error().code, ErrorCode::InvalidArgument);
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST(FrameRingThreads, one_pushes_while_others_read) {
  FrameRing ring({.longest = std::chrono::milliseconds(300)});
  std::jthread reader([&](std::stop_token stop) {
    while (!stop.stop_requested()) {
      const auto frames = everything(ring);
      for (std::size_t i = 1; i < frames.size(); ++i) EXPECT_GT(frames[i].time, frames[i - 1].time);
      EXPECT_LE(to_seconds(ring.held().length), 0.3 + 1e-9);
    }
  });
  for (std::size_t i = 0; i < 200; ++i) ring.push(numbered_frame(320, 240, i, 0.02 * static_cast<double>(i)));
}

}  // namespace
}  // namespace posecoach
