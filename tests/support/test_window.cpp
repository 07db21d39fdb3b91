#include "tests/support/test_window.h"

#include <cmath>

#include "core/base/assert.h"
#include "tests/support/offscreen.h"

namespace posecoach {

namespace {

Interface& test_interface() {
  (void)test_renderer();  // the process's context
  // Never destroyed, as the context below it.
  static Interface& interface = *[] {
    Result<std::unique_ptr<Interface>> made = Interface::make(Interface::Drawing::OpenGl);
    POSECOACH_ASSERT(made.has_value());
    return made->release();
  }();
  return interface;
}

}  // namespace

TestWindow::TestWindow(int width, int height, double scale)
    : width_(width),
      height_(height),
      scale_(scale),
      interface_(test_interface()),
      target_(static_cast<int>(std::lround(width * scale)), static_cast<int>(std::lround(height * scale))) {}

TestWindow::~TestWindow() = default;

void TestWindow::frame(const Theme& theme, const Draw& draw) {
  FrameInput input;
  input.size = {width_, height_};
  input.scale = scale_;
  time_s += elapsed_s;
  input.time_s = time_s;
  input.elapsed_s = elapsed_s;
  input.keys = std::exchange(keys_, {});
  input.dropped_files = std::exchange(dropped_, {});
  interface_.set_mouse(mouse_, is_pressed_);
  std::unique_ptr<Ui> ui = interface_.begin(input, theme, views_);
  draw(*ui);
  interface_.end(std::move(ui));
  target_.begin();
  interface_.draw();
  views_.end_frame();
}

Image TestWindow::picture() const {
  return target_.read_image();
}

void TestWindow::move_mouse(const Vec2& to) {
  mouse_ = to;
}
void TestWindow::press_mouse() {
  is_pressed_ = true;
}
void TestWindow::release_mouse() {
  is_pressed_ = false;
}

}  // namespace posecoach
