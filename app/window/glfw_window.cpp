#include "app/window/glfw_window.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>
#include <stb_image.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/embedded.h"
#include "ui/render/picture_texture.h"

POSECOACH_EMBEDDED(window_icon)

namespace posecoach {
namespace {

std::string last_glfw_error() {
  const char* words = nullptr;
  (void)glfwGetError(&words);
  return words == nullptr ? "no reason was given" : words;
}

// Letters as the user's own keyboard names them.
Key key_of(int key, int scancode) {
  if (key > GLFW_KEY_SPACE && key < GLFW_KEY_ESCAPE)
    if (const char* name = glfwGetKeyName(key, scancode); name != nullptr && name[0] != 0 && name[1] == 0) {
      const char c = name[0];
      return static_cast<Key>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
    }
  switch (key) {
    case GLFW_KEY_KP_ENTER:
      return Key::Enter;
    case GLFW_KEY_KP_ADD:
      return Key::Plus;
    case GLFW_KEY_KP_SUBTRACT:
      return Key::Minus;
    default:
      return static_cast<Key>(key);
  }
}

KeyPress press_of(int key, int scancode, int modifiers) {
  KeyPress press{key_of(key, scancode), (modifiers & GLFW_MOD_SHIFT) != 0,
                 (modifiers & GLFW_MOD_CONTROL) != 0};
  // What is + on one keyboard is Shift and = on another.
  if (press.key == Key::Equal && press.shift) press = {Key::Plus, false, press.control};
  return press;
}

// Where the desktop takes icons from windows (X11); others take the installed one, by the window's class.
void set_icon(GLFWwindow* window) {
  const std::string_view png = window_icon();
  GLFWimage icon{};
  int channels = 0;
  icon.pixels =
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(png.data()), static_cast<int>(png.size()),
                            &icon.width, &icon.height, &channels, STBI_rgb_alpha);
  if (icon.pixels != nullptr) glfwSetWindowIcon(window, 1, &icon);
  stbi_image_free(icon.pixels);
}

// In the middle of what the desktop's bars leave free, most of it, but never smaller than it was made.
void fit_to_desktop(GLFWwindow* window) {
  GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
  if (monitor == nullptr) return;
  constexpr double kShare = 0.86, kShape = 16.0 / 9;
  int left = 0, top = 0, across = 0, down = 0, width = 0, height = 0;
  glfwGetMonitorWorkarea(monitor, &left, &top, &across, &down);
  glfwGetWindowSize(window, &width, &height);
  if (across <= 0 || down <= 0) return;
  const double wanted = std::min(kShare * across, kShare * down * kShape);
  width = std::min(across, std::max(width, static_cast<int>(wanted)));
  height = std::min(down, std::max(height, static_cast<int>(wanted / kShape)));
  glfwSetWindowSize(window, width, height);
  glfwSetWindowPos(window, left + (across - width) / 2, top + (down - height) / 2);
}

}  // namespace

GlfwWindow::GlfwWindow(GLFWwindow* window) : window_(window) {
  glfwSetWindowUserPointer(window_, this);
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(1);
  listen();
}

GlfwWindow::~GlfwWindow() {
  disconnect();
  glfwDestroyWindow(window_);
  glfwTerminate();
}

Result<std::unique_ptr<GlfwWindow>> GlfwWindow::open(const std::string& title, int width, int height) {
  if (glfwInit() != GLFW_TRUE)
    return fail(ErrorCode::Unsupported, "there is no display for the window (" + last_glfw_error() +
                                            "); `posecoach analyze` and the other commands work without one");
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "virtual-pose-coach");
  glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "virtual-pose-coach");
  GLFWwindow* const window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (window == nullptr) {
    const std::string reason = last_glfw_error();
    glfwTerminate();
    return fail(ErrorCode::Unsupported, "the window needs OpenGL 3.3: " + reason);
  }
  set_icon(window);
  glfwSetWindowSizeLimits(window, 640, 400, GLFW_DONT_CARE, GLFW_DONT_CARE);
  fit_to_desktop(window);
  return std::unique_ptr<GlfwWindow>(new GlfwWindow(window));
}

void GlfwWindow::listen() {
  const auto self = [](GLFWwindow* window) {
    return static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window));
  };
  static const auto of = self;
  glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int scancode, int action, int modifiers) {
    GlfwWindow& it = *of(window);
    it.was_touched_ = true;
    // Alt and the logo key are the desktop's.
    if (action == GLFW_RELEASE || key == GLFW_KEY_UNKNOWN ||
        (modifiers & (GLFW_MOD_ALT | GLFW_MOD_SUPER)) != 0)
      return;
    (action == GLFW_REPEAT ? it.repeated_ : it.keys_).push_back(press_of(key, scancode, modifiers));
  });
  // Every keyboard has its question mark somewhere else.
  glfwSetCharCallback(window_, [](GLFWwindow* window, unsigned character) {
    if (character == '?') of(window)->keys_.push_back({Key::Question});
  });
  glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
    of(window)->was_touched_ = true;
    of(window)->dropped_.insert(of(window)->dropped_.end(), paths, paths + count);
  });
  glfwSetCursorPosCallback(window_,
                           [](GLFWwindow* window, double, double) { of(window)->was_touched_ = true; });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int button, int action, int) {
    of(window)->was_touched_ = true;
    if (button != GLFW_MOUSE_BUTTON_LEFT) return;
    ButtonTurn turn{action == GLFW_PRESS};
    glfwGetCursorPos(window, &turn.x, &turn.y);
    of(window)->button_turns_.push_back(turn);
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* window, double, double) { of(window)->was_touched_ = true; });
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* window) { of(window)->was_touched_ = true; });
  glfwSetFramebufferSizeCallback(window_,
                                 [](GLFWwindow* window, int, int) { of(window)->was_touched_ = true; });
}

void GlfwWindow::connect() {
  // Chains to the callbacks that are there.
  ImGui_ImplGlfw_InitForOpenGL(window_, true);
  is_connected_ = true;
}

void GlfwWindow::disconnect() {
  if (is_connected_) ImGui_ImplGlfw_Shutdown();
  is_connected_ = false;
}

FrameInput GlfwWindow::next_input(double longest_wait_s, double text_size) {
  was_touched_ = false;
  if (longest_wait_s > 0 && keys_.empty() && button_turns_.empty())
    glfwWaitEventsTimeout(longest_wait_s);
  else
    glfwPollEvents();
  ImGui_ImplGlfw_NewFrame();
  FrameInput input;
  int width = 0, height = 0, width_px = 0, height_px = 0;
  glfwGetWindowSize(window_, &width, &height);
  glfwGetFramebufferSize(window_, &width_px, &height_px);
  float scale_x = 1, scale_y = 1;
  glfwGetWindowContentScale(window_, &scale_x, &scale_y);
  // In steps, so that fonts are sharp and not made anew at every turn. A large window is larger in
  // everything, whatever the display says: it is looked at from further away.
  constexpr double kUsualWidth = 1536, kUsualHeight = 820;
  const double room = std::floor(4 * std::min(width_px / kUsualWidth, height_px / kUsualHeight)) / 4;
  const double wanted = std::max({static_cast<double>(std::max(scale_x, scale_y)), room}) * text_size;
  input.scale = std::clamp(std::round(4 * wanted) / 4, 0.75, 4.0);
  input.size = Vec2(std::max(1, width_px), std::max(1, height_px)) / input.scale;
  ImGuiIO& io = ImGui::GetIO();
  // One turn a frame: of two quick clicks within one slow frame Dear ImGui would see one.
  if (!button_turns_.empty()) {
    const ButtonTurn turn = button_turns_.front();
    button_turns_.erase(button_turns_.begin());
    is_button_down_ = turn.is_down;
    io.MousePos = ImVec2(static_cast<float>(turn.x), static_cast<float>(turn.y));
    was_touched_ = true;
  }
  io.MouseDown[ImGuiMouseButton_Left] = is_button_down_;
  if (io.MousePos.x > -1e6F && width > 0 && height > 0) {
    io.MousePos.x *= static_cast<float>(input.size.x / width);
    io.MousePos.y *= static_cast<float>(input.size.y / height);
  }
  input.time_s = glfwGetTime();
  input.elapsed_s = std::clamp(input.time_s - last_time_s_, 1e-4, 0.5);
  last_time_s_ = input.time_s;
  // One press a frame: each finds the window as the one before left it. What is being written comes all at
  // once, as its letters do: Enter must find them there.
  if (ImGui::GetIO().WantTextInput) {
    input.keys = std::exchange(keys_, {});
    was_touched_ = was_touched_ || !input.keys.empty();
  } else if (!keys_.empty()) {
    input.keys.push_back(keys_.front());
    keys_.erase(keys_.begin());
    was_touched_ = true;
  }
  input.repeated_keys = std::exchange(repeated_, {});
  input.dropped_files = std::exchange(dropped_, {});
  return input;
}

void GlfwWindow::clear() {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  clear_window(width, height);
}

void GlfwWindow::appear() {
  glfwShowWindow(window_);
}

void GlfwWindow::show() {
  glfwSwapBuffers(window_);
}

bool GlfwWindow::wants_to_close() const {
  return glfwWindowShouldClose(window_) == GLFW_TRUE;
}

void GlfwWindow::close() {
  glfwSetWindowShouldClose(window_, GLFW_TRUE);
}

void GlfwWindow::toggle_full_screen() {
  if (glfwGetWindowMonitor(window_) != nullptr) {
    glfwSetWindowMonitor(window_, nullptr, saved_[0], saved_[1], saved_[2], saved_[3], GLFW_DONT_CARE);
    return;
  }
  glfwGetWindowPos(window_, &saved_[0], &saved_[1]);
  glfwGetWindowSize(window_, &saved_[2], &saved_[3]);
  GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
  if (monitor == nullptr) return;
  const GLFWvidmode* const mode = glfwGetVideoMode(monitor);
  glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

}  // namespace posecoach
