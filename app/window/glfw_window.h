// The window on the screen, its keys and its mouse. The only place that knows GLFW.
#pragma once

#include <memory>
#include <string>

#include "core/base/error.h"
#include "ui/widgets/ui.h"

struct GLFWwindow;

namespace posecoach {

class GlfwWindow {
 public:
  // With an OpenGL 3.3 core context, current on this thread. Errors: Unsupported (no display, no OpenGL).
  static Result<std::unique_ptr<GlfwWindow>> open(const std::string& title, int width, int height);
  ~GlfwWindow();
  GlfwWindow(const GlfwWindow&) = delete;
  GlfwWindow& operator=(const GlfwWindow&) = delete;

  // Mouse and keys reach Dear ImGui from now on; its context must live as long as the connection.
  void connect();
  void disconnect();

  // Waits for the user at most so long. `text_size` is a factor on what the display says.
  FrameInput next_input(double longest_wait_s, double text_size);
  // Whether anything happened in the last wait.
  bool was_touched() const { return was_touched_; }
  // Fills the window with black, before a frame is drawn.
  void clear();
  // Nobody sees it before, so that it is never empty.
  void appear();
  void show();

  bool wants_to_close() const;
  void close();
  void toggle_full_screen();

 private:
  explicit GlfwWindow(GLFWwindow* window);
  void listen();

  GLFWwindow* window_;
  bool is_connected_ = false, was_touched_ = true;
  double last_time_s_ = 0;
  int saved_[4] = {0, 0, 1280, 720};  // place and size before full screen
  std::vector<KeyPress> keys_, repeated_;
  struct ButtonTurn {
    bool is_down = false;
    double x = 0, y = 0;
  };
  std::vector<ButtonTurn> button_turns_;  // of the mouse's first button
  bool is_button_down_ = false;
  std::vector<std::string> dropped_;
};

}  // namespace posecoach
