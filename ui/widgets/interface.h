// The machinery below the window's panels: Dear ImGui's context, the fonts at their sizes, and the drawing of
// a finished frame. One at a time in a process, on one thread.
#pragma once

#include <memory>

#include "core/base/error.h"
#include "ui/widgets/ui.h"

namespace posecoach {

class Interface {
 public:
  enum class Drawing {
    None,   // frames are built and thrown away: for measuring
    OpenGl  // into the current framebuffer of the current context
  };
  // Errors: Unsupported when OpenGL does not do.
  static Result<std::unique_ptr<Interface>> make(Drawing drawing);
  ~Interface();
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;

  // Starts a frame. The theme and the views must outlive it.
  std::unique_ptr<Ui> begin(const FrameInput& input, const Theme& theme, SceneViews& views);
  // Ends it; it is drawn by draw().
  void end(std::unique_ptr<Ui> ui);
  // Draws the frame that was ended last.
  void draw();

  // For those who play the mouse: tests. Points; `pressed` is the left button.
  void set_mouse(const Vec2& at, bool pressed, double wheel = 0);

 private:
  explicit Interface(Drawing drawing);
  void load_fonts(double scale);

  Drawing drawing_;
  std::unique_ptr<InterfaceState> state_;
};

}  // namespace posecoach
