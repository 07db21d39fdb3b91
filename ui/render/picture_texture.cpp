#include "ui/render/picture_texture.h"

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "core/base/assert.h"

namespace posecoach {
namespace {

void flip(const Image& from, Image& to) {
  for (int y = 0; y < from.height; ++y)
    std::copy_n(from.pixel(0, from.height - 1 - y), 3 * static_cast<std::size_t>(from.width), to.pixel(0, y));
}

}  // namespace

PictureTexture::PictureTexture(const Image& image) {
  POSECOACH_ASSERT(!image.empty());
  texture_ = gl::make_rgba_texture(image.width, image.height);
  glBindTexture(GL_TEXTURE_2D, texture_.id());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, image.width, image.height, GL_RGB, GL_UNSIGNED_BYTE,
                  image.rgb.data());
  glBindTexture(GL_TEXTURE_2D, 0);
}

OffscreenTarget::OffscreenTarget(int width, int height)
    : width_(width),
      height_(height),
      texture_(gl::make_rgba_texture(width, height)),
      framebuffer_(gl::make_framebuffer()) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.id(), 0);
  POSECOACH_ASSERT(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
}

void OffscreenTarget::begin() {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  glDisable(GL_SCISSOR_TEST);
  glViewport(0, 0, width_, height_);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
}

Image OffscreenTarget::read_image() const {
  Image image = Image::black(width_, height_), upright = image;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.id());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, image.rgb.data());
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  flip(image, upright);
  return upright;
}

bool is_drawn_by_software() {
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::string_view renderer = name == nullptr ? "" : name;
  return renderer.find("llvmpipe") != std::string_view::npos ||
         renderer.find("softpipe") != std::string_view::npos ||
         renderer.find("SWR") != std::string_view::npos;
}

Image read_window(double x, double y, double width, double height) {
  std::array<GLint, 4> view = {};
  glGetIntegerv(GL_VIEWPORT, view.data());
  const int left = std::clamp(static_cast<int>(std::lround(x)), 0, view[2] - 1),
            top = std::clamp(static_cast<int>(std::lround(y)), 0, view[3] - 1);
  const int across = std::clamp(static_cast<int>(std::lround(width)), 1, view[2] - left),
            down = std::clamp(static_cast<int>(std::lround(height)), 1, view[3] - top);
  Image image = Image::black(across, down), upright = image;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(left, view[3] - top - down, across, down, GL_RGB, GL_UNSIGNED_BYTE, image.rgb.data());
  flip(image, upright);
  return upright;
}

void clear_window(int width, int height) {
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glDisable(GL_SCISSOR_TEST);
  glViewport(0, 0, width, height);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
}

}  // namespace posecoach
