// The camera against a driver that misbehaves in every way that real ones do.
#include "capture/v4l2/camera.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/videodev2.h>

#include <thread>

#include "capture/bar_code.h"
#include "tests/capture/numbered_film.h"
#include "tests/support/fake_camera.h"

namespace posecoach {
namespace {

using Kind = FakeCamera::Step::Kind;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr int kWidth = 320, kHeight = 240;
constexpr auto kPeriod = std::chrono::milliseconds(33);

Duration now() {
  return std::chrono::steady_clock::now().time_since_epoch();
}

class CameraTest : public testing::Test {
 protected:
  CameraTest() : start_(now() - std::chrono::seconds(5)) { reset({}); }
  ~CameraTest() override {
    camera_.reset();
    EXPECT_THAT(driver_->broken_rules(), IsEmpty());
    EXPECT_EQ(driver_->left_open(), 0);
    EXPECT_EQ(driver_->left_mapped(), 0);
  }

  void reset(FakeCamera::Habits habits) {
    if (habits.modes.empty()) habits.modes = {{V4L2_PIX_FMT_MJPEG, kWidth, kHeight, {30}}};
    driver_ = std::make_unique<FakeCamera>("/dev/video0", std::move(habits));
  }
  Result<void> open(const CameraWish& wish = {}) {
    auto camera = V4l2Camera::open({.path = "/dev/video0",
                                    .wish = wish,
                                    .longest_silence = std::chrono::milliseconds(200),
                                    .system_calls = driver_.get()});
    if (!camera) return tl::unexpected(camera.error());
    camera_ = *std::move(camera);
    return {};
  }
  static Bytes jpeg(std::uint32_t number, int width = kWidth, int height = kHeight) {
    JpegEncoder encoder;
    return encoder.encode(numbered_picture(width, height, number), 90);
  }
  void picture(std::uint32_t sequence, Kind kind = Kind::Picture) {
    driver_->then({kind, jpeg(sequence), sequence, start_ + sequence * kPeriod});
  }
  Frame next() {
    auto frame = camera_->next({});
    EXPECT_TRUE(frame) << frame.error().message;
    return frame && *frame ? **frame : Frame{};
  }
  ErrorCode next_error() {
    const auto frame = camera_->next({});
    EXPECT_FALSE(frame);
    return frame ? ErrorCode::Internal : frame.error().code;
  }

  Duration start_;
  std::unique_ptr<FakeCamera> driver_;
  std::unique_ptr<V4l2Camera> camera_;
};

TEST_F(CameraTest, frames_carry_the_drivers_stamps_and_numbers) {
  for (std::uint32_t i = 10; i < 30; ++i) picture(i);
  ASSERT_TRUE(open());
  for (std::uint32_t i = 0; i < 20; ++i) {
    const Frame frame = next();
    EXPECT_EQ(frame.index, i);
    EXPECT_EQ(read_bar_code(*frame.image), 10 + i);
    EXPECT_NEAR(to_seconds(frame.time), to_seconds(i * kPeriod), 2e-6);
    EXPECT_NEAR(to_seconds(frame.captured_at->time_since_epoch() - start_), to_seconds((10 + i) * kPeriod),
                2e-6);
  }
  EXPECT_EQ(camera_->statistics().delivered, 20U);
  EXPECT_EQ(camera_->statistics().lost, 0U);
}

TEST_F(CameraTest, the_drivers_answer_is_believed) {
  reset({.modes = {{V4L2_PIX_FMT_MJPEG, 1280, 720, {60}}}, .only_width = kWidth, .only_height = kHeight});
  picture(0);
  ASSERT_TRUE(open({1280, 720, 60}));
  EXPECT_EQ(camera_->info().width, kWidth);
  EXPECT_EQ(camera_->info().height, kHeight);
  EXPECT_EQ(camera_->info().nominal_fps, 60);
  EXPECT_EQ(next().image->width, kWidth);
}

TEST_F(CameraTest, padded_rows_of_raw_pictures_are_understood) {
  reset({.modes = {{V4L2_PIX_FMT_RGB24, kWidth, kHeight, {30}}}, .row_padding_bytes = 32});
  const Image image = numbered_picture(kWidth, kHeight, 99);
  Bytes padded;
  for (int y = 0; y < kHeight; ++y) {
    padded.insert(padded.end(), image.pixel(0, y), image.pixel(0, y) + 3 * kWidth);
    padded.insert(padded.end(), 32, 0xEE);
  }
  driver_->then({Kind::Picture, padded, 0, now()});
  ASSERT_TRUE(open());
  EXPECT_EQ(next().image->rgb, image.rgb);
}

TEST_F(CameraTest, gaps_in_the_drivers_count_are_gaps_in_the_frames) {
  for (const std::uint32_t sequence : {0U, 1U, 4U, 5U, 9U}) picture(sequence);
  ASSERT_TRUE(open());
  std::vector<std::size_t> indices;
  for (int i = 0; i < 5; ++i) indices.push_back(next().index);
  EXPECT_EQ(indices, (std::vector<std::size_t>{0, 1, 4, 5, 9}));
  EXPECT_EQ(camera_->statistics().lost, 5U);
}

TEST_F(CameraTest, a_count_that_wraps_stands_still_or_starts_again_is_followed) {
  for (const std::uint32_t sequence : {0xFFFFFFFEU, 0xFFFFFFFFU, 0U, 2U, 2U, 2U, 0U})
    driver_->then({Kind::Picture, jpeg(1), sequence, now()});
  ASSERT_TRUE(open());
  std::vector<std::size_t> indices;
  for (int i = 0; i < 7; ++i) indices.push_back(next().index);
  EXPECT_EQ(indices, (std::vector<std::size_t>{0, 1, 2, 4, 5, 6, 7}));
}

TEST_F(CameraTest, time_increases_whatever_the_stamps_do) {
  const Duration stamps[] = {start_, start_ + kPeriod, start_ + kPeriod, start_, {}, start_ + 3 * kPeriod};
  for (std::uint32_t i = 0; i < 6; ++i) driver_->then({Kind::Picture, jpeg(i), i, stamps[i]});
  ASSERT_TRUE(open());
  MediaTime last = next().time;
  for (int i = 1; i < 6; ++i) {
    const MediaTime time = next().time;
    EXPECT_GT(time, last) << i;
    last = time;
  }
}

TEST_F(CameraTest, stamps_of_another_clock_are_not_taken_for_ours) {
  reset({.stamps_are_monotonic = false});
  for (std::uint32_t i = 0; i < 3; ++i)
    driver_->then({Kind::Picture, jpeg(i), i, std::chrono::hours(400000)});
  ASSERT_TRUE(open());
  for (int i = 0; i < 3; ++i)
    EXPECT_LT(std::abs(to_seconds(next().captured_at->time_since_epoch() - now())), 60);
}

TEST_F(CameraTest, broken_pictures_are_left_out_and_counted) {
  picture(0);
  picture(1, Kind::Flagged);
  Bytes cut = jpeg(2);
  cut.resize(cut.size() / 2);
  driver_->then({Kind::Picture, cut, 2, start_ + 2 * kPeriod});
  driver_->then({Kind::Picture, {}, 3, start_ + 3 * kPeriod});
  picture(4);
  ASSERT_TRUE(open());
  EXPECT_EQ(next().index, 0U);
  const Frame frame = next();
  EXPECT_EQ(frame.index, 4U);
  EXPECT_EQ(read_bar_code(*frame.image), 4U);
  EXPECT_EQ(camera_->statistics().broken, 3U);
  EXPECT_EQ(camera_->statistics().delivered, 2U);
}

TEST_F(CameraTest, waits_through_signals_and_waits_that_bring_nothing) {
  for (const Kind kind : {Kind::Again, Kind::Interrupted, Kind::Nothing, Kind::Again}) driver_->then(kind);
  picture(0);
  ASSERT_TRUE(open());
  EXPECT_EQ(read_bar_code(*next().image), 0U);
}

TEST_F(CameraTest, a_camera_that_falls_silent_says_so_and_may_wake_up) {
  picture(0);
  ASSERT_TRUE(open());
  next();
  EXPECT_EQ(next_error(), ErrorCode::DeviceLost);
  picture(1);
  EXPECT_EQ(next().index, 1U);
}

TEST_F(CameraTest, nothing_but_broken_pictures_is_a_stall) {
  driver_->then_forever({1, 2, 3});
  ASSERT_TRUE(open());
  const auto frame = camera_->next({});
  ASSERT_FALSE(frame);
  EXPECT_EQ(frame.error().code, ErrorCode::DeviceLost);
  EXPECT_THAT(frame.error().message, HasSubstr("damaged"));
}

TEST_F(CameraTest, a_stream_that_fails_is_started_again) {
  picture(0);
  driver_->then(Kind::Failing);
  picture(5);
  ASSERT_TRUE(open());
  next();
  EXPECT_EQ(next().index, 5U);
  EXPECT_EQ(driver_->started(), 2);
}

TEST_F(CameraTest, a_stream_that_fails_again_and_again_is_an_error) {
  for (int i = 0; i < 10; ++i) driver_->then(Kind::Failing);
  ASSERT_TRUE(open());
  EXPECT_EQ(next_error(), ErrorCode::Unreadable);
  EXPECT_LE(driver_->started(), 5);
}

TEST_F(CameraTest, unplugging_is_told) {
  picture(0);
  driver_->then(Kind::Gone);
  ASSERT_TRUE(open());
  next();
  EXPECT_EQ(next_error(), ErrorCode::DeviceLost);
  EXPECT_EQ(next_error(), ErrorCode::DeviceLost) << "asking again changes nothing";
}

TEST_F(CameraTest, another_size_of_pictures_is_told_so_that_the_camera_is_opened_again) {
  picture(0);
  driver_->then(Kind::NewSize);
  ASSERT_TRUE(open());
  next();
  EXPECT_EQ(next_error(), ErrorCode::DeviceLost);
}

TEST_F(CameraTest, one_picture_of_another_size_is_damage_and_several_are_a_change) {
  picture(0);
  driver_->then({Kind::Picture, jpeg(1, 640, 480), 1, now()});
  picture(2);
  for (std::uint32_t i = 3; i < 6; ++i) driver_->then({Kind::Picture, jpeg(i, 640, 480), i, now()});
  ASSERT_TRUE(open());
  EXPECT_EQ(next().index, 0U);
  EXPECT_EQ(next().index, 2U);
  const auto frame = camera_->next({});
  ASSERT_FALSE(frame);
  EXPECT_EQ(frame.error().code, ErrorCode::DeviceLost);
  EXPECT_THAT(frame.error().message, HasSubstr("320x240 to 640x480"));
}

TEST_F(CameraTest, a_camera_that_never_keeps_to_its_size_is_used_as_it_is) {
  for (std::uint32_t i = 0; i < 5; ++i) driver_->then({Kind::Picture, jpeg(i, 640, 480), i, now()});
  ASSERT_TRUE(open());
  EXPECT_EQ(next().image->width, 640);
  EXPECT_EQ(camera_->info().width, 640);
  EXPECT_EQ(next().image->height, 480);
}

TEST_F(CameraTest, a_stop_is_heard_while_nothing_comes) {
  auto camera = V4l2Camera::open(
      {.path = "/dev/video0", .longest_silence = std::chrono::hours(1), .system_calls = driver_.get()});
  ASSERT_TRUE(camera);
  std::stop_source stop;
  std::jthread stopper([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    stop.request_stop();
  });
  const auto frame = (*camera)->next(stop.get_token());
  ASSERT_FALSE(frame);
  EXPECT_EQ(frame.error().code, ErrorCode::Cancelled);
}

TEST_F(CameraTest, what_keeps_a_camera_from_opening_is_said_with_what_to_do) {
  const struct {
    int open_error, start_error;
    ErrorCode code;
    const char* words;
  } rows[] = {{EACCES, 0, ErrorCode::Unreadable, "group \"video\""},
              {EBUSY, 0, ErrorCode::Unreadable, "another program"},
              {ENODEV, 0, ErrorCode::DeviceLost, "unplugged"},
              {0, ENOSPC, ErrorCode::Unsupported, "smaller size"},
              {0, EBUSY, ErrorCode::Unreadable, "another program"}};
  for (const auto& row : rows) {
    reset({.open_error = row.open_error, .start_error = row.start_error});
    const Result<void> opened = open();
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().code, row.code) << row.words;
    EXPECT_THAT(opened.error().message, HasSubstr("/dev/video0"));
    EXPECT_THAT(opened.error().message, HasSubstr(row.words));
    EXPECT_EQ(driver_->left_open(), 0);
    EXPECT_EQ(driver_->left_mapped(), 0);
  }
}

TEST_F(CameraTest, what_is_no_camera_is_refused) {
  reset({.is_camera = false});
  EXPECT_EQ(open().error().code, ErrorCode::Unsupported);
  reset({.modes = {{V4L2_PIX_FMT_H264, 1280, 720, {30}}}});
  EXPECT_EQ(open().error().code, ErrorCode::Unsupported);
  driver_->unplug();
  EXPECT_EQ(open().error().code, ErrorCode::NotFound);
}

}  // namespace
}  // namespace posecoach
