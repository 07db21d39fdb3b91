#include <cmath>
#include <string>

#include "ui/panels/review_film_view.h"
#include "ui/panels/review_panels.h"
#include "ui/render/overlay_scene.h"
#include "ui/report/stills.h"
#include "ui/widgets/controls.h"

namespace posecoach {
namespace {

// The other student, moved so that both stand in one place when their strokes begin.
std::optional<PosedBody> other_student(const ReviewSwing& first, const ReviewSwing& second, int picture) {
  std::optional<PosedBody> body = bodies_at(second, matching_picture(first, second, picture)).student;
  if (!body || first.events.empty() || second.events.empty()) return body;
  const auto a = bodies_at(first, first.events.front()).student,
             b = bodies_at(second, second.events.front()).student;
  if (!a || !b) return body;
  const Vec3 by = feet_of(*a) - feet_of(*b);
  for (Vec3& position : body->positions) position += by;
  return body;
}

std::optional<HumanoidJoint> advised_joint(const Analysis& analysis, int chosen, int picture) {
  if (chosen < 0 || chosen >= static_cast<int>(analysis.advice.size())) return {};
  const Advice& advice = analysis.advice[static_cast<std::size_t>(chosen)];
  if (advice.kind != AdviceKind::Spatial || advice.student_frame != picture) return {};
  for (const SpatialAdvice& spatial : analysis.spatial)
    if (spatial.student_frame == advice.student_frame) return humanoid_joint_from_string(spatial.joint);
  return {};
}

// Whose film or body it is; returns the place behind.
double draw_label(Ui& ui, const Vec2& at, double width, std::string_view words,
                  const Colour& ink = colour_from_hex(0xF3F6FA)) {
  const Pill pill{words, ink, colour_from_hex(0x0C1016).with_alpha(0.82F)};
  const double wide = std::min(pill_width(ui, pill), width);
  draw_pill(ui, {at.x, at.y, wide, 24}, pill);
  return at.x + wide + 6;
}

}  // namespace

FilmMarks marks_of(const ReviewSwing& review) {
  return {review.times_s, review.events};
}

int shown_picture(const PanelContext& context) {
  const int count = context.model.opened ? context.model.opened->review->picture_count() : 0;
  return std::clamp(context.state.playback.frame, 0, std::max(0, count - 1));
}

FilmPlace draw_film(const PanelContext& context, const Rect& area, const FilmView& film) {
  Ui& ui = context.ui;
  ui.fill(area, colour_from_hex(0x07090C), radius::kMedium);
  const ReviewSwing& review = *film.swing->review;
  const std::optional<ShownPicture> shown =
      film.swing->picture ? film.swing->picture(film.picture) : std::nullopt;
  const PoseTrack& track = review.swing->track;
  const FilmPlace place = place_film(area, track.width, track.height, film.zoom, film.is_mirrored);
  if (!shown || !shown->image) {
    const double angle = 4 * ui.time_s();
    ui.arc(area.centre(), 14, angle, angle + 1.6, colour_from_hex(0xA9B5C4), 3);
    return place;
  }
  const double wanted = place.whole.width * place.whole.height * ui.scale() * ui.scale();
  const double factor =
      ui.scale() * std::min(1.0, std::sqrt(ui.views().most_pixels() / std::max(1.0, wanted)));
  const int width = std::max(16, static_cast<int>(std::lround(place.whole.width * factor))),
            height = std::max(16, static_cast<int>(std::lround(place.whole.height * factor)));
  const Palette palette = context.theme().palette;
  const std::optional<HumanoidJoint> joint =
      film.over ? std::nullopt : advised_joint(review.analysis(), context.state.chosen_advice, shown->frame);
  const std::uint64_t version =
      scene_version({1.0 * shown->frame, 1.0 * width, 1.0 * height, palette == Palette::RedGreen ? 0.0 : 1.0,
                     film.over ? 1.0 : 0.0, joint ? static_cast<double>(*joint) : -1.0},
                    shown->image.get()) ^
      scene_version({}, &review);
  const TextureName texture = ui.views().scene(film.name, version, [&] {
    BodiesAtPicture bodies = bodies_at(review, shown->frame);
    if (film.over) bodies.coach = other_student(review, *film.over, shown->frame);
    SceneView view;
    view.camera = scaled_to(review.swing->student.camera, width, height);
    OverlayMoment moment;
    moment.film = shown->image;
    if (bodies.student) moment.student.emplace(bodies.student->state());
    if (bodies.coach) moment.coach.emplace(bodies.coach->state());
    std::optional<OverlayHighlight> highlight;
    if (joint && moment.student && moment.coach) {
      const Vec3 into = glm::transpose(view.camera.rotation_camera_from_world) * Vec3(0, 0, 1);
      if (const auto apart = joint_apart(*moment.student, *moment.coach, joint, into))
        highlight = {apart->student, apart->coach};
    }
    view.scene = make_bodies_scene(moment, palette, view.camera, highlight);
    return view;
  });
  const bool fills = place.whole.width >= area.width - 1 && place.whole.height >= area.height - 1;
  const ClipScope clip(ui, area);
  ui.texture(texture, place.whole, fills && film.zoom.factor <= 1 ? radius::kMedium : 0, film.is_mirrored);
  return place;
}

void draw_films(const PanelContext& context, const Rect& area) {
  Ui& ui = context.ui;
  const WindowModel& model = context.model;
  WindowState& state = context.state;
  state.film_area = area;
  if (!model.opened) return;
  const int picture = shown_picture(context);
  const OpenedSwing& first = *model.opened;
  const bool shows_two = model.compared && state.compare == CompareLook::SideBySide;
  const Rect left = shows_two ? area.column(0, 2, space::kSmall) : area;
  FilmView view{.name = "film",
                .swing = &first,
                .picture = picture,
                .is_mirrored = state.is_mirrored,
                .zoom = state.zoom};
  if (model.compared && !shows_two) view.over = model.compared->review.get();
  const FilmPlace place = draw_film(context, left, view);
  if (!model.compared) return draw_marking(context, place, picture);
  if (!shows_two) {
    draw_marking(context, place, picture);
    const Theme film = make_theme(ThemeKind::Dark, context.theme().palette);
    const double half = 0.5 * (area.width - 250);
    const double next = draw_label(ui, area.corner() + Vec2(10), half, first.title, film.student_text);
    (void)draw_label(ui, {next, area.y + 10}, half, model.compared->title, film.coach_text);
    return;
  }
  const OpenedSwing& second = *model.compared;
  const Rect right = area.column(1, 2, space::kSmall);
  (void)draw_film(context, right,
                  {.name = "second film",
                   .swing = &second,
                   .picture = matching_picture(*first.review, *second.review, picture),
                   .is_mirrored = state.is_mirrored,
                   .zoom = state.zoom});
  draw_marking(context, place, picture);
  (void)draw_label(ui, left.corner() + Vec2(10), left.width - 270, first.title);
  (void)draw_label(ui, right.corner() + Vec2(10), right.width - 20, second.title);
}

}  // namespace posecoach
