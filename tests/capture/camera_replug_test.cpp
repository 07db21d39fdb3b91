// A camera that is unplugged and plugged in again, on the live loop's capture thread.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/videodev2.h>

#include <condition_variable>
#include <fstream>

#include "capture/v4l2/camera.h"
#include "capture/v4l2/camera_name.h"
#include "core/pipeline/frame_pump.h"
#include "tests/capture/numbered_film.h"
#include "tests/support/fake_camera.h"
#include "tests/support/temporary_folder.h"

namespace posecoach {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

TEST(CameraReplug, comes_back_under_another_number_without_a_restart_and_without_hurry) {
  const TemporaryFolder folder;
  const fs::path first = folder.path() / "video0", second = folder.path() / "video3";
  const fs::path by_id = folder.path() / "v4l" / "by-id" / "usb-C1-video-index0";
  for (const fs::path& node : {first, second}) std::ofstream(node) << "";
  fs::create_directories(by_id.parent_path());
  fs::create_symlink(first, by_id);

  FakeCamera::Habits habits;
  habits.modes = {{V4L2_PIX_FMT_MJPEG, 320, 240, {30}}};
  FakeCamera driver(first, habits);
  driver.then_forever(JpegEncoder().encode(numbered_picture(320, 240, 5), 90));

  std::mutex mutex;
  std::condition_variable changed;
  std::vector<Frame> frames;
  // Set up as for a user who named /dev/video0.
  const std::string name = stable_camera_name("camera:" + first.string(), {folder.path(), &driver});
  const int opened_before = driver.opened();
  {
    FramePump pump(
        [&](const std::string& source) -> Result<std::unique_ptr<FrameSource>> {
          const auto camera_name = parse_camera_name(source);
          auto camera = V4l2Camera::open({.path = camera_name->path, .system_calls = &driver});
          if (!camera) return tl::unexpected(camera.error());
          return *std::move(camera);
        },
        [&](const PumpedFrame& frame) {
          const std::scoped_lock lock(mutex);
          frames.push_back(frame.frame);
          changed.notify_all();
        },
        {.first_retry = 100ms, .longest_retry = 200ms});
    pump.set_source({name});
    const auto wait_for = [&](std::size_t count) {
      std::unique_lock lock(mutex);
      return changed.wait_for(lock, 60s, [&] { return frames.size() >= count; });
    };
    ASSERT_TRUE(wait_for(5));
    driver.unplug();
    while (pump.status().state != SourceState::Lost) std::this_thread::sleep_for(1ms);
    EXPECT_THAT(pump.status().message, testing::HasSubstr("unplugged"));
    std::size_t before = 0;
    {
      const std::scoped_lock lock(mutex);
      before = frames.size();
    }
    std::this_thread::sleep_for(500ms);
    // At 100, 300, 500 ms: it is looked for, but not in a hurry.
    EXPECT_LE(driver.opened() - opened_before, 6);
    fs::remove(by_id);
    fs::create_symlink(second, by_id);
    driver.plug_in_at(second);
    ASSERT_TRUE(wait_for(before + 5));
    EXPECT_EQ(pump.status().state, SourceState::Live);
  }
  for (std::size_t i = 1; i < frames.size(); ++i) {
    EXPECT_GT(frames[i].index, frames[i - 1].index);
    EXPECT_GT(frames[i].time, frames[i - 1].time);
  }
  EXPECT_THAT(driver.broken_rules(), testing::IsEmpty());
  EXPECT_EQ(driver.left_open(), 0);
  EXPECT_EQ(driver.left_mapped(), 0);
}

}  // namespace
}  // namespace posecoach
