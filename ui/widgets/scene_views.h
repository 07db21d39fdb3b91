// Where panels get pictures from: scenes drawn off screen, and plain pictures, as textures. The window's
// implementation draws with OpenGL; measurements of the interface alone use one that draws nothing.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>

#include "core/image/camera.h"
#include "ui/render/scene.h"

namespace posecoach {

struct SceneView {
  Scene scene;
  PinholeCamera camera;  // its size is that of the picture
};

// As the drawing library names it; 0 for nothing.
using TextureName = std::uintptr_t;

class SceneViews {
 public:
  virtual ~SceneViews() = default;
  // The scene of this name. It is made and drawn again only when `version` is another than last time.
  virtual TextureName scene(std::string_view name, std::uint64_t version,
                            const std::function<SceneView()>& make) = 0;
  virtual TextureName picture(const std::shared_ptr<const Image>& image) = 0;
  // The most pixels that a scene should have here: software drawing is slow on large windows.
  virtual double most_pixels() const = 0;
};

// Draws nothing, but makes every scene.
class NoSceneViews : public SceneViews {
 public:
  TextureName scene(std::string_view, std::uint64_t, const std::function<SceneView()>& make) override;
  TextureName picture(const std::shared_ptr<const Image>&) override { return 0; }
  double most_pixels() const override { return 4e6; }
};

}  // namespace posecoach
