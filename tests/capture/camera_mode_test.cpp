#include "capture/v4l2/camera_mode.h"

#include <gtest/gtest.h>
#include <linux/videodev2.h>

#include <algorithm>
#include <random>

namespace posecoach {
namespace {

constexpr std::uint32_t kYuyv = V4L2_PIX_FMT_YUYV, kMjpeg = V4L2_PIX_FMT_MJPEG;

// As most webcams are: raw pictures are slow where they are large.
std::vector<CameraMode> usual_webcam() {
  return {{kMjpeg, 1920, 1080, {30}}, {kMjpeg, 1280, 720, {60, 30}}, {kMjpeg, 640, 480, {30, 15}},
          {kYuyv, 1920, 1080, {5}},   {kYuyv, 1280, 720, {10, 5}},   {kYuyv, 640, 480, {30, 15}}};
}

void expect_mode(const std::optional<ChosenMode>& chosen, std::uint32_t format, int width, int height,
                 double fps) {
  ASSERT_TRUE(chosen);
  EXPECT_EQ(pixel_format_name(chosen->pixel_format), pixel_format_name(format));
  EXPECT_EQ(chosen->width, width);
  EXPECT_EQ(chosen->height, height);
  EXPECT_EQ(chosen->fps, fps);
}

TEST(CameraMode, mjpeg_where_raw_pictures_cannot_reach_the_rate) {
  expect_mode(choose_mode(usual_webcam(), {}), kMjpeg, 1280, 720, 60);
  expect_mode(choose_mode(usual_webcam(), {1280, 720, 30}), kMjpeg, 1280, 720, 30);
  expect_mode(choose_mode(usual_webcam(), {1920, 1080, 0}), kMjpeg, 1920, 1080, 30);
}

TEST(CameraMode, raw_pictures_where_they_are_quick_enough) {
  expect_mode(choose_mode(usual_webcam(), {640, 480, 30}), kYuyv, 640, 480, 30);
  expect_mode(choose_mode(usual_webcam(), {1280, 720, 10}), kYuyv, 1280, 720, 10);
}

TEST(CameraMode, a_format_that_was_asked_for_comes_first_and_one_that_is_not_there_counts_for_nothing) {
  expect_mode(choose_mode(usual_webcam(), {640, 480, 30, "MJPG"}), kMjpeg, 640, 480, 30);
  expect_mode(choose_mode(usual_webcam(), {640, 480, 30, "YUYV"}), kYuyv, 640, 480, 30);
  expect_mode(choose_mode(usual_webcam(), {1280, 720, 30, "YUYV"}), kYuyv, 1280, 720, 10);
  expect_mode(choose_mode(usual_webcam(), {640, 480, 30, "H264"}), kYuyv, 640, 480, 30);
}

TEST(CameraMode, a_small_quick_picture_before_a_large_slow_one_unless_the_size_was_asked_for) {
  const std::vector<CameraMode> raw_only = {{kYuyv, 1280, 720, {10}}, {kYuyv, 640, 480, {30}}};
  expect_mode(choose_mode(raw_only, {}), kYuyv, 640, 480, 30);
  expect_mode(choose_mode(raw_only, {1280, 720, 0}), kYuyv, 1280, 720, 10);
}

TEST(CameraMode, a_rate_that_drivers_round_counts_as_the_rate) {
  const std::vector<CameraMode> ntsc = {{kMjpeg, 1280, 720, {30}}, {kYuyv, 1280, 720, {30000.0 / 1001}}};
  expect_mode(choose_mode(ntsc, {1280, 720, 30}), kYuyv, 1280, 720, 30000.0 / 1001);
}

TEST(CameraMode, a_driver_that_tells_no_rates_is_used_all_the_same) {
  expect_mode(choose_mode(std::vector<CameraMode>{{kYuyv, 640, 480, {}}}, {}), kYuyv, 640, 480, 0);
  EXPECT_FALSE(choose_mode({}, {}));
}

TEST(CameraMode, the_choice_is_one_of_the_modes_whatever_is_wished_and_does_not_hang_on_their_order) {
  std::mt19937 random(7);
  const auto pick = [&](auto... values) {
    const std::vector<int> all = {values...};
    return all[random() % all.size()];
  };
  for (int round = 0; round < 500; ++round) {
    std::vector<CameraMode> modes;
    const int count = pick(1, 2, 5, 9);
    for (int i = 0; i < count; ++i)
      modes.push_back({random() % 2 == 0 ? kYuyv : kMjpeg,
                       pick(320, 640, 1280, 1920),
                       pick(240, 480, 720, 1080),
                       {static_cast<double>(pick(60, 90)), static_cast<double>(pick(5, 10, 30))}});
    const CameraWish wish = {pick(0, 640, 1234), pick(0, 480, 777), static_cast<double>(pick(0, 25, 60))};
    const auto chosen = choose_mode(modes, wish);
    ASSERT_TRUE(chosen);
    bool is_one = false;
    for (const CameraMode& mode : modes)
      for (const double rate : mode.frame_rates)
        is_one |= mode.pixel_format == chosen->pixel_format && mode.width == chosen->width &&
                  mode.height == chosen->height && rate == chosen->fps;
    EXPECT_TRUE(is_one);
    std::reverse(modes.begin(), modes.end());
    const auto again = choose_mode(modes, wish);
    EXPECT_EQ(again->fps, chosen->fps);
    EXPECT_EQ(again->pixel_format, chosen->pixel_format);
  }
}

}  // namespace
}  // namespace posecoach
