#include "app/bench/bench.h"
#include "core/body/standard_body.h"
#include "ui/render/egl_context.h"
#include "ui/render/overlay_scene.h"
#include "ui/render/scene_renderer.h"

namespace posecoach {

// A film frame with both bodies, score and time lines, drawn and read back as `analyze --video` does.
Result<void> bench_render(const BenchOptions&, std::vector<BenchRow>& rows) {
  const Result<std::unique_ptr<OffscreenContext>> context = make_egl_context();
  if (!context) return tl::unexpected(context.error());
  Result<SceneRenderer> renderer = SceneRenderer::make();
  if (!renderer) return tl::unexpected(renderer.error());

  const Skeleton body = make_standard_body();
  std::vector<Vec3> coach(body.rest_positions().begin(), body.rest_positions().end());
  for (Vec3& p : coach) p += Vec3(0.1, 0, 0.05);
  OverlayStory story;
  story.score_percent = 80;
  for (int i = 0; i < 44; ++i) story.links.emplace_back(i / 43.0, i / 43.0);
  OverlayMoment moment;
  moment.film = std::make_shared<Image>(Image::black(1280, 720));
  moment.student.emplace(BodyState{body, body.rest_positions()});
  moment.coach.emplace(BodyState{body, coach});
  moment.student_fraction = 0.4;
  moment.coach_fraction = 0.5;
  moment.phase = "Backswing";
  moment.apart_m = 0.05;
  const PinholeCamera camera =
      make_camera_looking_at({0, 1.1, 4.6}, {0, 0.9, 0}, radians_from_degrees(36), 1280, 720);
  rows.push_back(measure("overlay frame 1280x720, " + (*context)->renderer_name(), 40, [&] {
    renderer->render(make_overlay_scene(story, moment, camera), camera);
    (void)renderer->read_image();
  }));
  return {};
}

}  // namespace posecoach
