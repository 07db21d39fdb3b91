// Scenes and pictures drawn with OpenGL. A context must be current whenever anything here runs.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "ui/render/picture_texture.h"
#include "ui/render/scene_renderer.h"
#include "ui/widgets/scene_views.h"

namespace posecoach {

class GlSceneViews : public SceneViews {
 public:
  explicit GlSceneViews(double most_pixels = 4e6) : most_pixels_(most_pixels) {}

  TextureName scene(std::string_view name, std::uint64_t version,
                    const std::function<SceneView()>& make) override;
  TextureName picture(const std::shared_ptr<const Image>& image) override;
  double most_pixels() const override { return most_pixels_; }

  // Once a frame: forgets what was not asked for during the last frames.
  void end_frame();

 private:
  struct View {
    std::optional<SceneRenderer> renderer;  // none where OpenGL refused
    std::uint64_t version = 0;
    bool is_drawn = false;
    int idle_frames = 0;
  };
  struct Picture {
    std::shared_ptr<const Image> image;  // keeps its address from being used by another
    PictureTexture texture;
    int idle_frames = 0;
  };
  double most_pixels_;
  std::map<std::string, View, std::less<>> views_;
  std::map<const Image*, Picture> pictures_;
};

}  // namespace posecoach
