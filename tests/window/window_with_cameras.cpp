// The real window on a machine with two cameras that are not real: for looking at it, and for driving it from
// outside (camera_change.sh). Usage:
//   window_with_cameras FOLDER
// FOLDER gets the cameras' devices; while FOLDER/unplugged is there, the first camera is pulled out. What
// each camera does is in FOLDER/cameras.
#include <linux/videodev2.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <map>
#include <thread>

#include "app/window/run_window.h"
#include "capture/simulated_student.h"
#include "capture/v4l2/jpeg.h"
#include "tests/support/fake_machine.h"

namespace posecoach {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

Bytes as_yuyv(const Image& image) {
  Bytes bytes;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* rgb = image.pixel(x, y);
      const double luma = 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2];
      const double colour = x % 2 == 0 ? 0.564 * (rgb[2] - luma) : 0.713 * (rgb[0] - luma);
      bytes.push_back(static_cast<std::uint8_t>(std::clamp(16 + 0.859 * luma, 16.0, 235.0)));
      bytes.push_back(static_cast<std::uint8_t>(std::clamp(128 + 0.878 * colour, 16.0, 240.0)));
    }
  return bytes;
}

// The simulated student's swing as the camera's mode wants it, a few pictures of it, drawn when they come
// first.
FakeCamera::Scene swing_from(CameraView view) {
  struct Drawn {
    std::unique_ptr<SimulatedStudent> student;
    std::map<std::size_t, Bytes> pictures;
  };
  auto modes = std::make_shared<std::map<std::tuple<std::uint32_t, int, int>, Drawn>>();
  return [view, modes](const ChosenMode& mode, std::uint32_t number) {
    Drawn& drawn = (*modes)[{mode.pixel_format, mode.width, mode.height}];
    if (!drawn.student) {
      SimulatedStudentOptions options;
      options.view.view = view;
      options.width = mode.width;
      options.height = mode.height;
      options.frames_per_second = 10;
      drawn.student = SimulatedStudent::make(options).value();
    }
    const std::size_t picture = number / 3 % *drawn.student->info().frame_count;
    Bytes& bytes = drawn.pictures[picture];
    if (bytes.empty()) {
      const Image image = drawn.student->draw(static_cast<int>(picture));
      bytes = mode.pixel_format == V4L2_PIX_FMT_MJPEG ? JpegEncoder().encode(image, 85) : as_yuyv(image);
    }
    return bytes;
  };
}

std::string words_of(const FakeCamera& camera) {
  if (camera.left_open() == 0) return "not used";
  const ChosenMode mode = camera.agreed();
  return std::to_string(mode.width) + "x" + std::to_string(mode.height) + " " +
         pixel_format_name(mode.pixel_format);
}

int run(const fs::path& folder) {
  FakeMachine machine(folder / "dev");
  FakeCamera::Habits habits;
  habits.name = "Front camera";
  habits.modes = {{V4L2_PIX_FMT_MJPEG, 1280, 720, {30}},
                  {V4L2_PIX_FMT_MJPEG, 640, 480, {30}},
                  {V4L2_PIX_FMT_YUYV, 640, 480, {30}}};
  FakeCamera& front = machine.add(0, habits);
  front.then_forever(swing_from(CameraView::FaceOn), std::chrono::milliseconds(33));
  habits.name = "Side camera";
  habits.modes = {{V4L2_PIX_FMT_YUYV, 640, 360, {30}}};
  FakeCamera& side = machine.add(1, habits);
  side.then_forever(swing_from(CameraView::DownTheLine), std::chrono::milliseconds(33));
  const std::jthread hand([&](const std::stop_token& stop) {
    bool is_out = false;
    while (!stop.stop_requested()) {
      if (fs::exists(folder / "unplugged") != is_out) {
        is_out = !is_out;
        is_out ? machine.unplug(front) : machine.plug_in(front, 4);
      }
      std::ofstream(folder / "cameras.new")
          << "front " << (is_out ? "gone" : words_of(front)) << "\nside " << words_of(side) << "\n";
      fs::rename(folder / "cameras.new", folder / "cameras");
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  });
  const Result<void> done =
      run_window({.source = "camera:" + machine.stable_path(front).string()}, {machine.cameras(), {}});
  if (!done) std::fprintf(stderr, "%s\n", done.error().message.c_str());
  return done ? 0 : 1;
}

}  // namespace
}  // namespace posecoach

int main(int count, char** arguments) {
  if (count == 2) return posecoach::run(arguments[1]);
  std::fputs("usage: window_with_cameras FOLDER\n", stderr);
  return 2;
}
