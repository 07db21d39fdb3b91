#include "app/bench/bench.h"
#include "app/sample/sample_swing.h"
#include "ui/screens/screens.h"
#include "ui/widgets/interface.h"

namespace posecoach {

// The interface's own time for a frame with everything shown: laying out, building what is to be drawn, and
// making the scenes; what a graphics card would do is left out.
Result<void> bench_window(const BenchOptions&, std::vector<BenchRow>& rows) {
  const Result<std::shared_ptr<const AnalyzedSwing>> swing =
      make_sample_swing({.fault = "early_extension=10", .height_m = 1.8});
  if (!swing) return tl::unexpected(swing.error());
  Result<std::unique_ptr<Interface>> interface = Interface::make(Interface::Drawing::None);
  if (!interface) return tl::unexpected(interface.error());
  const Result<std::shared_ptr<const Image>> picture = (*swing)->pictures->picture(0);
  if (!picture) return tl::unexpected(picture.error());

  const auto review = make_review_swing(*swing);
  WindowModel model;
  const PictureLookup lookup = [image = *picture](int wanted) { return ShownPicture{wanted, image}; };
  model.opened = OpenedSwing{"a", "Swing 14", "today", review, lookup, true, {}};
  model.jobs = {{1, "Exporting", "drawing", 0.4}};
  model.toasts = {{1, ToastKind::Good, "The swing is kept.", "", {}}};
  for (int i = 0; i < 200; ++i) {
    SwingCard card;
    card.id = std::to_string(i);
    card.title = "Swing " + card.id;
    card.when = "today";
    card.score_percent = i % 100;
    model.swings.push_back(card);
  }
  const auto snapshot = std::make_shared<CoachSnapshot>();
  const BodiesAtPicture bodies = bodies_at(*review, 40);
  snapshot->source_state = SourceState::Live;
  snapshot->frame = Frame{40, {}, {}, *picture};
  snapshot->camera = (*swing)->student.camera;
  const auto pose = [](const PosedBody& body) {
    return BodyPose{std::make_shared<const Skeleton>(*body.skeleton), body.positions, body.confidence};
  };
  if (bodies.student) snapshot->student = pose(*bodies.student);
  if (bodies.coach) snapshot->ghost = Ghost{pose(*bodies.coach), 0, 0, {}};
  snapshot->loop = LoopState::Armed;
  snapshot->checks = {{SetUpTopic::WholeBody, SetUpLevel::Good, "All of you is in the picture."},
                      {SetUpTopic::View, SetUpLevel::Poor, "Turn a little more towards the camera."}};
  snapshot->address_advice = {"Bend 5° more from the hips.", "Stand 6 cm wider."};
  model.snapshot = snapshot;

  const Theme theme = make_theme(ThemeKind::Dark, Palette::RedGreen);
  NoSceneViews views;
  WindowState state;
  FrameInput input;
  Intents intents;
  for (const auto& [screen, name] :
       {std::pair(ScreenName::Live, "live"), std::pair(ScreenName::Review, "review"),
        std::pair(ScreenName::Library, "library")}) {
    state.screen = screen;
    rows.push_back(measure("interface frame 1280x720, " + std::string(name), 200, [&] {
      input.time_s += input.elapsed_s;
      state.playback.frame = (state.playback.frame + 1) % review->picture_count();
      std::unique_ptr<Ui> ui = (*interface)->begin(input, theme, views);
      draw_window({*ui, model, state, intents}, ui->whole());
      (*interface)->end(std::move(ui));
    }));
  }
  return {};
}

}  // namespace posecoach
