// A picture on the graphics card, and a framebuffer to draw a window's contents into where there is no
// window. A context must be current whenever anything here runs, destructors included.
#pragma once

#include "core/image/frame.h"
#include "ui/render/gl/objects.h"

namespace posecoach {

class PictureTexture {
 public:
  // Asserts a picture that is not empty.
  explicit PictureTexture(const Image& image);
  unsigned name() const { return texture_.id(); }

 private:
  gl::Handle texture_;
};

// Rows are stored as a window's are: the lowest first.
class OffscreenTarget {
 public:
  OffscreenTarget(int width, int height);
  // Everything that is drawn from now on goes here; filled with black.
  void begin();
  Image read_image() const;

 private:
  int width_, height_;
  gl::Handle texture_, framebuffer_;
};

// Of the current context: whether the processor draws, for want of a graphics card.
bool is_drawn_by_software();

// The window's own framebuffer, made black and drawn into from now on.
void clear_window(int width, int height);
// What is drawn there now, of this rectangle in pixels, +Y down.
Image read_window(double x, double y, double width, double height);

}  // namespace posecoach
