// The renderer in tests: one OSMesa context and one SceneRenderer for the whole process.
#pragma once

#include "ui/render/scene_renderer.h"

namespace posecoach {

SceneRenderer& test_renderer();

Image render_image(const Scene& scene, const PinholeCamera& camera);

}  // namespace posecoach
