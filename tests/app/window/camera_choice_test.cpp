// The cameras of a machine as the window's user meets them: chosen from the list with their modes, pulled
// out, plugged in again, and never a restart.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/videodev2.h>

#include <map>

#include "capture/v4l2/jpeg.h"
#include "tests/app/window/driven_window.h"
#include "tests/support/fake_machine.h"

namespace posecoach {
namespace {

using testing::HasSubstr;

// A flat picture of that mode, whose brightness tells the camera.
FakeCamera::Scene flat(std::uint8_t brightness) {
  auto jpegs = std::make_shared<std::map<std::pair<int, int>, std::vector<std::uint8_t>>>();
  return [brightness, jpegs](const ChosenMode& mode, std::uint32_t) {
    auto& bytes = (*jpegs)[{mode.width, mode.height}];
    Image image = Image::black(mode.width, mode.height);
    std::fill(image.rgb.begin(), image.rgb.end(), brightness);
    if (mode.pixel_format == V4L2_PIX_FMT_MJPEG) {
      if (bytes.empty()) bytes = JpegEncoder().encode(image, 90);
      return bytes;
    }
    std::vector<std::uint8_t> yuyv(static_cast<std::size_t>(2 * mode.width * mode.height), 128);
    for (std::size_t i = 0; i < yuyv.size(); i += 2) yuyv[i] = brightness;
    return yuyv;
  };
}

class CameraChoice : public testing::Test {
 protected:
  CameraChoice() : machine_(places_.folder("dev")) {
    FakeCamera::Habits habits;
    habits.name = "Front camera";
    habits.modes = {{V4L2_PIX_FMT_MJPEG, 1280, 720, {30}},
                    {V4L2_PIX_FMT_MJPEG, 640, 480, {30}},
                    {V4L2_PIX_FMT_YUYV, 640, 480, {30}}};
    front_ = &machine_.add(0, habits);
    front_->then_forever(flat(60), std::chrono::milliseconds(5));
    habits.name = "Side camera";
    habits.modes = {{V4L2_PIX_FMT_YUYV, 320, 240, {30, 15}}, {V4L2_PIX_FMT_YUYV, 160, 120, {30}}};
    side_ = &machine_.add(2, habits);
    side_->then_forever(flat(200), std::chrono::milliseconds(5));
  }
  ~CameraChoice() override {
    for (const FakeCamera* camera : {front_, side_}) {
      EXPECT_THAT(camera->broken_rules(), testing::IsEmpty());
      EXPECT_EQ(camera->left_open(), 0);
      EXPECT_EQ(camera->left_mapped(), 0);
    }
  }
  LiveDevices devices() { return {machine_.cameras(), {}}; }
  std::string source_of(const FakeCamera* camera) {
    return "camera:" + machine_.stable_path(*camera).string();
  }
  static bool shows(const WindowModel& model, int width, int height, int brightness) {
    const CoachSnapshot& snapshot = *model.snapshot;
    if (snapshot.source_state != SourceState::Live || !snapshot.frame) return false;
    const Image& image = *snapshot.frame->image;
    return image.width == width && image.height == height && std::abs(image.pixel(0, 0)[1] - brightness) < 25;
  }
  static const CameraEntry* entry_of(const WindowModel& model, const std::string& source) {
    for (const CameraEntry& camera : model.cameras)
      if (camera.source == source) return &camera;
    return nullptr;
  }

  WindowPlaces places_;
  FakeMachine machine_;
  FakeCamera* front_ = nullptr;
  FakeCamera* side_ = nullptr;
};

TEST_F(CameraChoice, another_mode_and_another_camera_of_the_list_show_their_pictures_without_a_restart) {
  DrivenWindow window({.source = source_of(front_)}, devices());
  const WindowModel& model =
      window.wait_until([](const WindowModel& now) { return shows(now, 1280, 720, 60); });
  ASSERT_GE(model.cameras.size(), 2U);
  const CameraEntry front = model.cameras[0], side = model.cameras[1];
  EXPECT_EQ(front.name, "Front camera");
  EXPECT_EQ(front.source, source_of(front_));
  ASSERT_EQ(front.modes.size(), 3U);
  ASSERT_EQ(side.modes.size(), 2U);
  // Each of the modes that the list shows, in turn, while the one before streams.
  for (const CameraEntry& camera : {front, side, front})
    for (const PictureMode& mode : camera.modes) {
      window.press(intent::ChooseSource{camera.source, mode});
      const int brightness = camera.name == "Front camera" ? 60 : 200;
      const WindowModel& now = window.wait_until(
          [&](const WindowModel& seen) { return shows(seen, mode.width, mode.height, brightness); });
      EXPECT_EQ(now.source, camera.source);
      const FakeCamera& driver = camera.name == "Front camera" ? *front_ : *side_;
      EXPECT_EQ(pixel_format_name(driver.agreed().pixel_format), mode.format);
      EXPECT_EQ(driver.agreed().fps, mode.fps);
    }
  window.press(intent::ChooseSource{side.source, {}});
  window.wait_until([](const WindowModel& now) { return shows(now, 320, 240, 200); });
  // The one that is not used is free for other programs.
  EXPECT_EQ(front_->left_open(), 0);
}

TEST_F(CameraChoice, one_that_is_pulled_out_is_told_and_goes_on_in_its_mode_when_it_is_there_again) {
  DrivenWindow window({.source = source_of(front_)}, devices());
  const PictureMode small = {640, 480, 30, "MJPG"};
  window.press(intent::ChooseSource{source_of(front_), small});
  window.wait_until([](const WindowModel& now) { return shows(now, 640, 480, 60); });
  machine_.unplug(*front_);
  window.state().screen = ScreenName::SetUp;
  const WindowModel& lost = window.wait_until(
      [](const WindowModel& now) { return now.snapshot->source_state == SourceState::Lost; });
  EXPECT_EQ(lost.snapshot->source_message,
            "Front camera is not plugged in. Plug it in again: it is used by itself.");
  // The list notices by itself; the lost one keeps its name.
  const auto detail_of_front = [&](const WindowModel& now) {
    const CameraEntry* front = entry_of(now, source_of(front_));
    return front == nullptr ? std::string() : front->name + ": " + front->detail;
  };
  window.wait_until(
      [&](const WindowModel& now) { return detail_of_front(now) == "Front camera: Not plugged in now"; });
  // The other one can be used meanwhile.
  window.press(intent::ChooseSource{source_of(side_), {}});
  window.wait_until([](const WindowModel& now) { return shows(now, 320, 240, 200); });
  window.press(intent::ChooseSource{source_of(front_), small});
  window.wait_until([](const WindowModel& now) { return now.snapshot->source_state == SourceState::Lost; });
  machine_.plug_in(*front_, 5);
  window.wait_until([](const WindowModel& now) { return shows(now, 640, 480, 60); });
  EXPECT_EQ(pixel_format_name(front_->agreed().pixel_format), "MJPG");
  const WindowModel& again = window.wait_until(
      [&](const WindowModel& now) { return detail_of_front(now).find("video5") != std::string::npos; });
  EXPECT_EQ(entry_of(again, source_of(front_))->modes.size(), 3U);
}

TEST_F(CameraChoice, one_that_changes_its_pictures_by_itself_goes_on_with_the_new_ones) {
  DrivenWindow window({.source = source_of(side_)}, devices());
  window.wait_until([](const WindowModel& now) { return shows(now, 320, 240, 200); });
  const int before = side_->started();
  side_->then(FakeCamera::Step::Kind::NewSize);
  window.wait_until(
      [&](const WindowModel& now) { return side_->started() > before && shows(now, 320, 240, 200); });
}

TEST_F(CameraChoice, the_next_start_takes_the_same_camera_in_the_same_mode) {
  const PictureMode raw = {640, 480, 30, "YUYV"};
  {
    DrivenWindow window({.source = source_of(side_)}, devices());
    window.press(intent::ChooseSource{source_of(front_), raw});
    window.wait_until([](const WindowModel& now) { return shows(now, 640, 480, 60); });
  }
  DrivenWindow window({}, devices());
  const WindowModel& model =
      window.wait_until([](const WindowModel& now) { return shows(now, 640, 480, 60); });
  EXPECT_EQ(model.mode, raw);
  EXPECT_EQ(pixel_format_name(front_->agreed().pixel_format), "YUYV");
}

TEST_F(CameraChoice, a_damaged_film_in_its_place_says_so_and_the_camera_is_there_again_at_a_press) {
  DrivenWindow window({.source = source_of(front_)}, devices());
  window.wait_until([](const WindowModel& now) { return shows(now, 1280, 720, 60); });
  window.press(intent::ChooseSource{places_.folder("no_such_film.mp4").string(), {}});
  const WindowModel& lost = window.wait_until(
      [](const WindowModel& now) { return now.snapshot->source_state == SourceState::Lost; });
  EXPECT_THAT(lost.snapshot->source_message, HasSubstr("no such file"));
  window.press(intent::ChooseSource{source_of(front_), {}});
  window.wait_until([](const WindowModel& now) { return shows(now, 1280, 720, 60); });
}

}  // namespace
}  // namespace posecoach
