#include "ui/widgets/gl_scene_views.h"

#include "core/base/log.h"

namespace posecoach {
namespace {

constexpr int kKeptFrames = 120;

}  // namespace

TextureName GlSceneViews::scene(std::string_view name, std::uint64_t version,
                                const std::function<SceneView()>& make) {
  auto found = views_.find(name);
  if (found == views_.end()) {
    View view;
    Result<SceneRenderer> renderer = SceneRenderer::make();
    if (renderer)
      view.renderer.emplace(std::move(*renderer));
    else
      log::error(renderer.error().message);
    found = views_.emplace(std::string(name), std::move(view)).first;
  }
  View& view = found->second;
  view.idle_frames = 0;
  if (!view.renderer) return 0;
  if (!view.is_drawn || view.version != version) {
    const SceneView made = make();
    if (made.camera.width_px <= 0 || made.camera.height_px <= 0) return 0;
    view.renderer->render(made.scene, made.camera);
    view.version = version;
    view.is_drawn = true;
  }
  return view.renderer->texture();
}

TextureName GlSceneViews::picture(const std::shared_ptr<const Image>& image) {
  if (!image || image->empty()) return 0;
  auto found = pictures_.find(image.get());
  if (found == pictures_.end())
    found = pictures_.emplace(image.get(), Picture{image, PictureTexture(*image), 0}).first;
  found->second.idle_frames = 0;
  return found->second.texture.name();
}

void GlSceneViews::end_frame() {
  for (auto& [name, view] : views_) ++view.idle_frames;
  for (auto& [address, picture] : pictures_) ++picture.idle_frames;
  std::erase_if(views_, [](const auto& entry) { return entry.second.idle_frames > kKeptFrames; });
  std::erase_if(pictures_, [](const auto& entry) { return entry.second.idle_frames > kKeptFrames; });
}

}  // namespace posecoach
