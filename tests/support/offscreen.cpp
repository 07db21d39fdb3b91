#include "tests/support/offscreen.h"

#include "core/base/assert.h"
#include "ui/render/osmesa_context.h"

namespace posecoach {
namespace {

struct Offscreen {
  std::unique_ptr<OffscreenContext> context;
  SceneRenderer renderer;
};

Offscreen make_offscreen() {
  Result<std::unique_ptr<OffscreenContext>> context = make_osmesa_context();
  POSECOACH_ASSERT(context.has_value());
  Result<SceneRenderer> renderer = SceneRenderer::make();
  POSECOACH_ASSERT(renderer.has_value());
  return {std::move(*context), std::move(*renderer)};
}

}  // namespace

SceneRenderer& test_renderer() {
  // Never destroyed: the library below may be gone by the time static objects end.
  static Offscreen& offscreen = *new Offscreen(make_offscreen());
  return offscreen.renderer;
}

Image render_image(const Scene& scene, const PinholeCamera& camera) {
  test_renderer().render(scene, camera);
  return test_renderer().read_image();
}

}  // namespace posecoach
