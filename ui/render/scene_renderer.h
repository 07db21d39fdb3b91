// Draws scenes with OpenGL 3.3 core. The same renderer serves films, reports, tests and the window: it always
// draws into its own texture, whose first row is the picture's top row.
#pragma once

#include <memory>

#include "core/base/error.h"
#include "core/image/camera.h"
#include "ui/render/scene.h"

namespace posecoach {

class SceneRenderer {
 public:
  // A context must be current here and whenever a method runs, the destructor included. Errors: Unsupported.
  static Result<SceneRenderer> make();
  SceneRenderer(SceneRenderer&& other) noexcept;
  SceneRenderer& operator=(SceneRenderer&& other) noexcept;
  ~SceneRenderer();

  // The picture gets the camera's size; pixel (x, y) of it is what the camera projects there.
  void render(const Scene& scene, const PinholeCamera& camera);

  // Of the last render.
  Image read_image() const;
  // The OpenGL name of the texture that holds it; valid until the next render.
  unsigned texture() const;

 private:
  struct State;
  explicit SceneRenderer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace posecoach
