// A window that nobody sees: the interface drawn into a picture, with mouse and keys in the test's hands.
#pragma once

#include <memory>

#include "core/image/frame.h"
#include "ui/panels/panel.h"
#include "ui/widgets/gl_scene_views.h"
#include "ui/widgets/interface.h"

namespace posecoach {

class TestWindow {
 public:
  TestWindow(int width, int height, double scale = 1);
  ~TestWindow();

  using Draw = std::function<void(Ui& ui)>;
  // One frame; the mouse stays where it was put.
  void frame(const Theme& theme, const Draw& draw);
  Image picture() const;

  void move_mouse(const Vec2& to);
  void press_mouse();
  void release_mouse();
  void press(KeyPress key) { keys_.push_back(key); }
  void drop(const std::string& path) { dropped_.push_back(path); }
  double time_s = 10;
  double elapsed_s = 0;  // stands still unless told otherwise: pictures are the same each time

 private:
  int width_, height_;
  double scale_;
  Interface& interface_;  // one for the process
  GlSceneViews views_;
  OffscreenTarget target_;
  Vec2 mouse_{-1e4, -1e4};
  bool is_pressed_ = false;
  std::vector<KeyPress> keys_;
  std::vector<std::string> dropped_;
};

}  // namespace posecoach
