#include "ui/render/scene_renderer.h"

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>

#include "core/base/assert.h"
#include "core/base/embedded.h"
#include "ui/render/gl/capsule_pass.h"
#include "ui/render/gl/flat_pass.h"
#include "ui/render/gl/floor_pass.h"
#include "ui/render/gl/objects.h"
#include "ui/render/gl/view.h"

namespace posecoach {
namespace {

POSECOACH_EMBEDDED(shader_picture_vert)
POSECOACH_EMBEDDED(shader_picture_frag)

constexpr int kSamples = 4;

}  // namespace

// One figure at a time is drawn with several samples a pixel into a layer of its own, resolved, and laid over
// the picture with its opacity; the picture itself needs one sample only.
struct SceneRenderer::State {
  gl::Program picture_program;
  gl::CapsulePass capsules;
  gl::FloorPass floor;
  gl::FlatPass flats;
  gl::Handle empty_array = gl::make_vertex_array();

  int width = 0, height = 0;
  gl::Handle target_texture{}, target{};
  gl::Handle layer_texture{}, layer{};
  gl::Handle samples_colour{}, samples_depth{}, samples{};
  int picture_width = 0, picture_height = 0;
  gl::Handle picture_texture{};

  void resize(int new_width, int new_height);
  void draw_background(const Scene& scene);
  void draw_figure(const Figure& figure, const gl::View& view);
  void draw_picture(unsigned texture, const gl::PixelBox& box, double opacity,
                    const PicturePart& source) const;
  // Of the target.
  PicturePart fractions_of(const gl::PixelBox& box) const {
    return {{static_cast<double>(box.left) / width, static_cast<double>(box.top) / height},
            {static_cast<double>(box.right) / width, static_cast<double>(box.bottom) / height}};
  }
};

namespace {

gl::Handle framebuffer_with_texture(const gl::Handle& texture) {
  gl::Handle framebuffer = gl::make_framebuffer();
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.id(), 0);
  POSECOACH_ASSERT(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
  return framebuffer;
}

gl::Handle multisampled(unsigned format, int width, int height, int count) {
  gl::Handle buffer = gl::make_renderbuffer();
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.id());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, count, format, width, height);
  return buffer;
}

void upload_rgb(const gl::Handle& texture, const Image& image) {
  glBindTexture(GL_TEXTURE_2D, texture.id());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, image.width, image.height, GL_RGB, GL_UNSIGNED_BYTE,
                  image.rgb.data());
}

}  // namespace

void SceneRenderer::State::resize(int new_width, int new_height) {
  if (new_width == width && new_height == height) return;
  width = new_width;
  height = new_height;
  target_texture = gl::make_rgba_texture(width, height);
  target = framebuffer_with_texture(target_texture);
  layer_texture = gl::make_rgba_texture(width, height);
  layer = framebuffer_with_texture(layer_texture);
  GLint most_samples = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &most_samples);
  const int count = std::min(kSamples, most_samples);
  samples_colour = multisampled(GL_RGBA8, width, height, count);
  samples_depth = multisampled(GL_DEPTH_COMPONENT24, width, height, count);
  samples = gl::make_framebuffer();
  glBindFramebuffer(GL_FRAMEBUFFER, samples.id());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, samples_colour.id());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, samples_depth.id());
  POSECOACH_ASSERT(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
}

void SceneRenderer::State::draw_background(const Scene& scene) {
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  const gl::PixelBox all{0, 0, width, height};
  if (scene.picture && !scene.picture->empty()) {
    const Image& image = *scene.picture;
    if (image.width == width && image.height == height && scene.part == PicturePart())
      return upload_rgb(target_texture, image);
    if (image.width != picture_width || image.height != picture_height) {
      picture_texture = gl::make_rgba_texture(image.width, image.height);
      picture_width = image.width;
      picture_height = image.height;
    }
    upload_rgb(picture_texture, image);
    return draw_picture(picture_texture.id(), all, 1, scene.part);
  }
  picture_program.use();
  glUniform1i(picture_program.uniform("is_gradient"), 1);
  const Colour& top = scene.background_top;
  const Colour& bottom = scene.background_bottom;
  glUniform3f(picture_program.uniform("gradient_top"), top.red, top.green, top.blue);
  glUniform3f(picture_program.uniform("gradient_bottom"), bottom.red, bottom.green, bottom.blue);
  glUniform4f(picture_program.uniform("rectangle"), 0, 0, 1, 1);
  glUniform4f(picture_program.uniform("source"), 0, 0, 1, 1);
  glBindVertexArray(empty_array.id());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void SceneRenderer::State::draw_picture(unsigned texture, const gl::PixelBox& box, double opacity,
                                        const PicturePart& source) const {
  const auto set = [&](const char* name, const PicturePart& part) {
    glUniform4f(picture_program.uniform(name), static_cast<float>(part.begin.x),
                static_cast<float>(part.begin.y), static_cast<float>(part.end.x),
                static_cast<float>(part.end.y));
  };
  picture_program.use();
  glUniform1i(picture_program.uniform("is_gradient"), 0);
  glUniform1i(picture_program.uniform("picture"), 0);
  glUniform1f(picture_program.uniform("opacity"), static_cast<float>(opacity));
  set("rectangle", fractions_of(box));
  set("source", source);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture);
  glBindVertexArray(empty_array.id());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void SceneRenderer::State::draw_figure(const Figure& figure, const gl::View& view) {
  const gl::PixelBox box = gl::CapsulePass::bounds(figure, view);
  if (box.empty() || figure.opacity <= 0) return;
  glEnable(GL_SCISSOR_TEST);
  glScissor(box.left, box.top, box.width(), box.height());
  glBindFramebuffer(GL_FRAMEBUFFER, samples.id());
  glDepthMask(GL_TRUE);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  capsules.draw(figure, view);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, samples.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, layer.id());
  glBlitFramebuffer(box.left, box.top, box.right, box.bottom, box.left, box.top, box.right, box.bottom,
                    GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glDisable(GL_SCISSOR_TEST);
  glBindFramebuffer(GL_FRAMEBUFFER, target.id());
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  draw_picture(layer_texture.id(), box, figure.opacity, fractions_of(box));
}

SceneRenderer::SceneRenderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
SceneRenderer::SceneRenderer(SceneRenderer&& other) noexcept = default;
SceneRenderer& SceneRenderer::operator=(SceneRenderer&& other) noexcept = default;
SceneRenderer::~SceneRenderer() = default;

Result<SceneRenderer> SceneRenderer::make() {
  Result<gl::Program> picture = gl::Program::make("picture", shader_picture_vert(), shader_picture_frag());
  if (!picture) return tl::unexpected(picture.error());
  Result<gl::CapsulePass> capsules = gl::CapsulePass::make();
  if (!capsules) return tl::unexpected(capsules.error());
  Result<gl::FloorPass> floor = gl::FloorPass::make();
  if (!floor) return tl::unexpected(floor.error());
  Result<gl::FlatPass> flats = gl::FlatPass::make();
  if (!flats) return tl::unexpected(flats.error());
  return SceneRenderer(std::make_unique<State>(
      State{std::move(*picture), std::move(*capsules), std::move(*floor), std::move(*flats)}));
}

void SceneRenderer::render(const Scene& scene, const PinholeCamera& camera) {
  POSECOACH_ASSERT(camera.width_px > 0 && camera.height_px > 0 && camera.focal_px > 0);
  State& s = *state_;
  s.resize(camera.width_px, camera.height_px);
  const gl::View view{camera};
  glViewport(0, 0, s.width, s.height);
  glDisable(GL_SCISSOR_TEST);
  glEnable(GL_MULTISAMPLE);
  glBindFramebuffer(GL_FRAMEBUFFER, s.target.id());
  s.draw_background(scene);
  if (scene.floor) s.floor.draw(*scene.floor, scene.figures, view);
  for (const Figure& figure : scene.figures) s.draw_figure(figure, view);
  glBindFramebuffer(GL_FRAMEBUFFER, s.target.id());
  s.flats.draw(scene.flats, s.width, s.height);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glUseProgram(0);
}

Image SceneRenderer::read_image() const {
  const State& s = *state_;
  POSECOACH_ASSERT(s.width > 0);
  Image image = Image::black(s.width, s.height);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, s.target.id());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, s.width, s.height, GL_RGB, GL_UNSIGNED_BYTE, image.rgb.data());
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  return image;
}

unsigned SceneRenderer::texture() const {
  return state_->target_texture.id();
}

}  // namespace posecoach
