// The camera code against a real kernel driver: Linux' own test driver "vivid", inside a virtual machine (see
// scripts/test-vivid). Plain checks instead of GoogleTest: only what the small machine needs.
#include <linux/videodev2.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <thread>

#include "capture/v4l2/camera.h"
#include "capture/v4l2/camera_list.h"
#include "capture/v4l2/camera_name.h"
#include "capture/v4l2/open_camera.h"
#include "capture/v4l2/system_calls.h"
#include "tests/vivid/driver_control.h"

namespace posecoach {
namespace {

constexpr const char* kNode = "/dev/video0";
constexpr int kWidth = 320, kHeight = 180;  // small: the machine is slow
int failures = 0, checks = 0;

void check(bool holds, const std::string& what) {
  ++checks;
  if (holds) return;
  ++failures;
  std::printf("FAILED: %s\n", what.c_str());
}

std::unique_ptr<V4l2Camera> open_small(const CameraWish& wish = {kWidth, kHeight, 30}) {
  auto camera = V4l2Camera::open({.path = kNode, .wish = wish});
  if (camera) return *std::move(camera);
  check(false, "open: " + camera.error().message);
  return nullptr;
}

struct Stretch {
  std::vector<Frame> frames;
  std::optional<Error> error;
};

Stretch take(V4l2Camera& camera, std::size_t count) {
  Stretch stretch;
  while (stretch.frames.size() < count) {
    auto frame = camera.next({});
    if (!frame) {
      stretch.error = frame.error();
      break;
    }
    stretch.frames.push_back(**std::move(frame));
  }
  check(!stretch.error, "frames come: " + (stretch.error ? stretch.error->message : ""));
  for (std::size_t i = 1; i < stretch.frames.size(); ++i)
    if (stretch.frames[i].index <= stretch.frames[i - 1].index ||
        stretch.frames[i].time <= stretch.frames[i - 1].time) {
      check(false, "numbers and times increase");
      break;
    }
  return stretch;
}

// The driver's test picture: eight upright bars of white, yellow, cyan, green, magenta, red, blue and black.
bool shows_colour_bars(const Image& image, bool is_grey) {
  constexpr bool kBars[8][3] = {{true, true, true},   {true, true, false},  {false, true, true},
                                {false, true, false}, {true, false, true},  {true, false, false},
                                {false, false, true}, {false, false, false}};
  int last_grey = 256;
  for (int bar = 0; bar < 8; ++bar) {
    const std::uint8_t* pixel = image.pixel(image.width * (2 * bar + 1) / 16, image.height * 9 / 10);
    if (is_grey) {  // ordered by brightness
      if (pixel[0] != pixel[1] || pixel[1] != pixel[2] || pixel[0] >= last_grey) return false;
      last_grey = pixel[0];
      continue;
    }
    for (int c = 0; c < 3; ++c)
      if (kBars[bar][c] ? pixel[c] < 150 : pixel[c] > 40) return false;
  }
  return true;
}

void lists_itself() {
  const auto cameras = list_cameras();
  check(cameras.size() == 1, "one camera is listed");
  if (cameras.empty()) return;
  check(cameras[0].driver == "vivid" && cameras[0].problem.empty(), "it is vivid and can be used");
  check(cameras[0].path.string().starts_with("/dev/v4l/by-path/"), "it has a stable path");
  check(cameras[0].node == kNode, "and its node");
  check(cameras[0].modes.size() > 4, "it tells its modes");
  for (const CameraMode& mode : cameras[0].modes) {
    check(!mode.frame_rates.empty(), "each mode tells its rates");
    if (mode.width == kWidth)
      std::printf("  %s %dx%d up to %.0f fps\n", pixel_format_name(mode.pixel_format).c_str(), mode.width,
                  mode.height, mode.frame_rates.empty() ? 0 : mode.frame_rates.front());
  }
  check(stable_camera_name("camera:") == cameras[0].source(), "the first camera is found by no name");
}

void decodes_every_format() {
  std::vector<std::uint32_t> seen;
  for (const CameraMode& mode : list_cameras().at(0).modes) {
    if (mode.width != kWidth || std::find(seen.begin(), seen.end(), mode.pixel_format) != seen.end())
      continue;
    seen.push_back(mode.pixel_format);
    const std::string name = pixel_format_name(mode.pixel_format);
    auto device = V4l2Device::open(kNode, real_v4l2_system_calls());
    if (!device) return check(false, device.error().message);
    const auto format = device->agree({mode.pixel_format, mode.width, mode.height, 30});
    if (!format) return check(false, format.error().message);
    check(format->pixel_format == mode.pixel_format && format->width == kWidth, name + " is agreed");
    auto stream = BufferStream::start(*device);
    if (!stream) return check(false, stream.error().message);
    for (int tries = 0; tries < 50; ++tries) {
      const auto filled = (*stream)->next(std::chrono::milliseconds(100));
      if (!filled) return check(false, filled.error().message);
      if (!*filled) continue;
      const auto image = PictureDecoder(*format).decode((*filled)->bytes);
      check(image && shows_colour_bars(*image, mode.pixel_format == V4L2_PIX_FMT_GREY),
            name + " shows the bars");
      break;
    }
  }
  check(seen.size() >= 4, "several formats were tried");
}

// As the window does when another mode is chosen from its list: the camera is opened anew by its name.
void changes_its_mode_while_it_streams() {
  const CameraDescription described = list_cameras().at(0);
  std::vector<CameraMode> modes;
  for (const std::uint32_t format : {V4L2_PIX_FMT_YUYV, V4L2_PIX_FMT_NV12, V4L2_PIX_FMT_GREY})
    for (const CameraMode& mode : described.modes)
      if (mode.width <= 640 && mode.pixel_format == format) modes.push_back(mode);
  check(modes.size() >= 6, "several modes were tried");
  Result<std::unique_ptr<V4l2Camera>> camera = open_camera(described.source());
  for (const CameraMode& mode : modes) {
    const std::string format = pixel_format_name(mode.pixel_format);
    const std::string size = std::to_string(mode.width) + "x" + std::to_string(mode.height);
    if (!camera) return check(false, camera.error().message);
    take(**camera, 2);  // it streams when it is told
    camera->reset();
    camera = open_camera(described.source() + "?width=" + std::to_string(mode.width) +
                         "&height=" + std::to_string(mode.height) + "&fps=15&format=" + format);
    if (!camera) return check(false, camera.error().message);
    check((*camera)->format().pixel_format == mode.pixel_format, format + " is what the driver agreed to");
    const Stretch stretch = take(**camera, 3);
    if (stretch.frames.empty()) continue;
    const Image& image = *stretch.frames.back().image;
    check(image.width == mode.width && image.height == mode.height, size + " " + format + " comes as " +
                                                                        std::to_string(image.width) + "x" +
                                                                        std::to_string(image.height));
    check(shows_colour_bars(image, mode.pixel_format == V4L2_PIX_FMT_GREY),
          size + " " + format + " shows the bars");
    std::printf("  %s %s\n", size.c_str(), format.c_str());
  }
}

void streams_with_the_drivers_clock() {
  auto camera = open_small();
  if (!camera) return;
  check(camera->info().width == kWidth && camera->info().height == kHeight, "the size that was asked for");
  const Stretch stretch = take(*camera, 60);
  if (stretch.frames.size() < 60) return;
  const Frame& last = stretch.frames.back();
  const double seconds = to_seconds(last.time);
  const double expected = static_cast<double>(last.index) / camera->info().nominal_fps;
  check(std::abs(seconds - expected) < 0.1 * expected + 0.05, "numbers and stamps agree on the rate");
  const double age = to_seconds(std::chrono::steady_clock::now() - *last.captured_at);
  // The driver stamps with the time when a frame was due, which may be a little after it was given.
  check(age > -1 / camera->info().nominal_fps && age < 5,
        "stamps are of our clock, not " + std::to_string(age) + " s old");
  std::printf("  60 frames in %.2f s, %llu lost by the driver\n", seconds,
              static_cast<unsigned long long>(camera->statistics().lost));
}

void survives_injected_errors() {
  auto camera = open_small();
  if (!camera) return;
  DriverControl control(kNode);
  take(*camera, 5);
  check(control.set("Inject V4L2_BUF_FLAG_ERROR", 1), "a damaged buffer is injected");
  take(*camera, 15);
  check(camera->statistics().broken == 1, "it is left out and counted");
  check(control.set("Inject Fatal Streaming Error", 1), "a failure of the stream is injected");
  take(*camera, 15);
  check(control.set("Percentage of Dropped Buffers", 40), "buffers are dropped");
  const auto lost_before = camera->statistics().lost;
  const Stretch stretch = take(*camera, 30);
  check(camera->statistics().lost > lost_before, "lost frames are counted");
  check(stretch.frames.size() == 30 && stretch.frames.back().index - stretch.frames.front().index > 29,
        "and are gaps in the numbers");
  check(control.set("Percentage of Dropped Buffers", 0), "no more are dropped");
}

void follows_a_count_that_wraps() {
  DriverControl control(kNode);
  check(control.set("Wrap Sequence Number", 1), "the driver's count is near its end");
  {
    auto camera = open_small();
    if (!camera) return;
    const Stretch stretch = take(*camera, 140);
    check(!stretch.frames.empty() && stretch.frames.back().index < 1000, "our numbers go on");
  }
  control.set("Wrap Sequence Number", 0);
}

void tells_why_it_cannot_start() {
  auto camera = open_small();
  const auto second = V4l2Camera::open({.path = kNode, .wish = {640, 360, 30}});
  check(!second && second.error().message.find("another program") != std::string::npos,
        "a camera in use says so");
  camera.reset();
  for (const char* injection : {"Inject VIDIOC_STREAMON Error", "Inject VIDIOC_REQBUFS Error"}) {
    check(DriverControl(kNode).set(injection, 1), injection);
    check(!V4l2Camera::open({.path = kNode}), "a start that fails is an error");
    check(open_small() != nullptr, "and the next start works");
  }
}

void hears_a_stop() {
  auto camera = open_small();
  if (!camera) return;
  std::stop_source stop;
  stop.request_stop();
  const auto frame = camera->next(stop.get_token());
  check(!frame && frame.error().code == ErrorCode::Cancelled, "a stop is heard");
}

void comes_back_after_a_disconnect() {
  auto camera = open_small();
  if (!camera) return;
  take(*camera, 5);
  check(DriverControl(kNode).set("Disconnect", 1), "the camera is disconnected");
  std::optional<Error> error;
  for (int i = 0; i < 100 && !error; ++i)
    if (auto frame = camera->next({}); !frame) error = frame.error();
  check(error && error->code == ErrorCode::DeviceLost, "the loss is told");
  if (error) std::printf("  \"%s\"\n", error->message.c_str());
  // The driver is there again once its last user has let go.
  camera.reset();
  camera = open_small();
  if (camera) take(*camera, 5);
}

}  // namespace
}  // namespace posecoach

int main() {
  using namespace posecoach;
  const struct {
    const char* name;
    void (*run)();
  } all[] = {{"lists itself", lists_itself},
             {"decodes every format", decodes_every_format},
             {"changes its mode while it streams", changes_its_mode_while_it_streams},
             {"streams with the driver's clock", streams_with_the_drivers_clock},
             {"survives injected errors", survives_injected_errors},
             {"follows a count that wraps", follows_a_count_that_wraps},
             {"tells why it cannot start", tells_why_it_cannot_start},
             {"hears a stop", hears_a_stop},
             {"comes back after a disconnect", comes_back_after_a_disconnect}};
  for (const auto& test : all) {
    std::printf("- %s\n", test.name);
    std::fflush(stdout);
    test.run();
  }
  std::printf("vivid: %d checks, %d failed\n", checks, failures);
  return failures == 0 ? 0 : 1;
}
