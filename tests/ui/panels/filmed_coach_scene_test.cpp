// What the live picture shows of a coach of whom there are only pictures.
#include <gtest/gtest.h>

#include "core/pipeline/coach_pipeline.h"
#include "core/transfer/closed_form.h"
#include "tests/core/pipeline/bodies.h"
#include "tests/core/pipeline/filmed.h"
#include "tests/support/filmed_golfer.h"
#include "tests/support/image_compare.h"
#include "tests/support/offscreen.h"
#include "ui/panels/live_scene.h"
#include "ui/theme/theme.h"

namespace posecoach {
namespace {

using enum GolferPart::Kind;

// The student stands at address; the coach is the top of a long-legged man's swing, without his left hand.
TEST(FilmedCoachScene, is_drawn_on_the_student_without_what_was_not_seen) {
  PoseTrack picture = film(tall_body(), {0, 1.2, 4.2}, 50, {}).track;
  picture.frames = {picture.frames[36]};
  for (const Landmark landmark :
       {Landmark::LeftWrist, Landmark::LeftIndex, Landmark::LeftPinky, Landmark::LeftThumb})
    picture.frames[0].person->image[landmark].visibility = 0.1;
  const auto golfer =
      std::make_shared<const GolferFilm>(film_golfer({.parts = {{Stand, 5}}}, scaled(face_on_camera(), 0.5)));
  InlineWork work;
  CoachPipeline pipeline(std::make_unique<KnowingEstimator>(golfer), work);
  pipeline.set_coach(filmed_coach_from(picture, [] {
                       return Result<std::unique_ptr<Transferer>>(
                           make_closed_form_transferer(TransferMethod::Ratio));
                     }).value());
  CoachSnapshot last;
  for (std::size_t i = 0; i < golfer->count(); ++i) last = pipeline.step(golfer->frame(i)).value();
  const Theme theme = make_theme(ThemeKind::Dark, Palette::RedGreen);
  const SceneView view =
      make_live_scene(last, {theme.palette, theme.good, theme.warning, theme.bad}, 640, 360);
  EXPECT_TRUE(matches_golden(render_image(view.scene, view.camera), "live_filmed_coach"));
}

}  // namespace
}  // namespace posecoach
