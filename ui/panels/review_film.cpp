#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "core/body/mirror.h"
#include "ui/panels/review_film_view.h"
#include "ui/panels/review_panels.h"
#include "ui/render/overlay_scene.h"
#include "ui/report/stills.h"
#include "ui/widgets/controls.h"

namespace posecoach {
namespace {

bool are_other_handed(const ReviewSwing& first, const ReviewSwing& second) {
  return first.analysis().student.hand != second.analysis().student.hand;
}

// As in a mirror that stands at `feet` along the camera's view.
void mirror(PosedBody& body, const PinholeCamera& camera, const Vec3& feet) {
  Vec3 across = glm::transpose(camera.rotation_camera_from_world) * Vec3(1, 0, 0);
  across.y = 0;
  across = glm::normalize(across);
  const std::vector<int> partners = mirror_partners(*body.skeleton);
  const PosedBody before = body;
  for (std::size_t i = 0; i < partners.size(); ++i) {
    const auto partner = static_cast<std::size_t>(partners[i]);
    const Vec3& at = before.positions[partner];
    body.positions[i] = at - 2 * glm::dot(at - feet, across) * across;
    if (partner < before.confidence.size()) body.confidence[i] = before.confidence[partner];
  }
}

// The other student, moved so that both stand in one place when their strokes begin; a left-hander over a
// right-hander is mirrored.
std::optional<PosedBody> other_student(const ReviewSwing& first, const ReviewSwing& second, int picture) {
  std::optional<PosedBody> body = bodies_at(second, matching_picture(first, second, picture)).student;
  if (!body || first.events.empty() || second.events.empty()) return body;
  const auto a = bodies_at(first, first.events.front()).student,
             b = bodies_at(second, second.events.front()).student;
  if (!a || !b) return body;
  if (are_other_handed(first, second)) mirror(*body, second.swing->student.camera, feet_of(*b));
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

std::string second_title(const WindowModel& model) {
  const bool is_mirrored = are_other_handed(*model.opened->review, *model.compared->review);
  return model.compared->title + (is_mirrored ? ", mirrored" : "");
}

// The wanted picture is not the one that is seen.
void draw_waiting(Ui& ui, const Rect& area, int picture) {
  const std::string words = "Fetching picture " + std::to_string(picture + 1);
  const Pill pill{words, colour_from_hex(0xF3F6FA), colour_from_hex(0x0C1016).with_alpha(0.82F), Icon::None};
  const double width = std::min(pill_width(ui, pill) + 20, area.width - 20);
  const Rect place{area.right() - width - 10, area.bottom() - 36, width, 26};
  ui.fill(place, pill.paper, 0.5 * place.height);
  const double angle = 5 * ui.time_s();
  ui.ring({place.x + 15, place.centre().y}, 6, pill.ink.with_alpha(0.25F), 2);
  ui.arc({place.x + 15, place.centre().y}, 6, angle, angle + 1.8, pill.ink, 2);
  ui.text_in(TextStyle::Caption, {place.x + 28, place.y, place.width - 36, place.height}, words, pill.ink);
}

void draw_unreadable(Ui& ui, const Rect& area, int picture) {
  const std::string words =
      "Picture " + std::to_string(picture + 1) + " cannot be read: the film is damaged or gone";
  const Pill pill{words, ui.theme().warning, colour_from_hex(0x0C1016).with_alpha(0.82F), Icon::Warning};
  const double width = std::min(pill_width(ui, pill), area.width - 20);
  draw_pill(ui, {area.right() - width - 10, area.bottom() - 36, width, 26}, pill);
}

}  // namespace

FilmMarks marks_of(const ReviewSwing& review) {
  return {review.times_s, review.events};
}

int shown_picture(const PanelContext& context) {
  const int count = context.model.opened ? context.model.opened->review->picture_count() : 0;
  return std::clamp(context.state.playback.frame, 0, std::max(0, count - 1));
}

FilmZoom golfer_zoom(const ReviewSwing& review, const Rect& area, bool is_mirrored) {
  if (!review.golfer_px) return {};
  const PoseTrack& track = review.swing->track;
  FilmZoom zoom = zoom_on(review.golfer_px->first, review.golfer_px->second, area, track.width, track.height);
  if (is_mirrored) zoom.centre.x = 1 - zoom.centre.x;
  return zoom;
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
    if (shown && shown->is_wanted_unreadable)
      draw_unreadable(ui, area, film.picture);
    else
      draw_waiting(ui, area, film.picture);
    return place;
  }
  const SeenFilm seen = seen_film(place);
  if (seen.on_screen.is_empty()) return place;
  const double wanted = seen.on_screen.width * seen.on_screen.height * ui.scale() * ui.scale();
  const double factor =
      ui.scale() * std::min(1.0, std::sqrt(ui.views().most_pixels() / std::max(1.0, wanted)));
  const int width = std::max(16, static_cast<int>(std::lround(seen.on_screen.width * factor))),
            height = std::max(16, static_cast<int>(std::lround(seen.on_screen.height * factor)));
  const Palette palette = context.theme().palette;
  const bool has_advice = !film.over && film.figures == FigureShow::Both;
  const std::optional<HumanoidJoint> joint =
      has_advice ? advised_joint(review.analysis(), context.state.chosen_advice, shown->frame) : std::nullopt;
  const std::uint64_t version =
      scene_version({1.0 * shown->frame, 1.0 * width, 1.0 * height, palette == Palette::RedGreen ? 0.0 : 1.0,
                     film.over ? 1.0 : 0.0, joint ? static_cast<double>(*joint) : -1.0,
                     static_cast<double>(film.figures), seen.part.begin.x, seen.part.begin.y, seen.part.end.x,
                     seen.part.end.y},
                    shown->image.get()) ^
      scene_version({}, &review);
  const TextureName texture = ui.views().scene(film.name, version, [&] {
    BodiesAtPicture bodies = bodies_at(review, shown->frame);
    if (film.over) bodies.coach = other_student(review, *film.over, shown->frame);
    SceneView view;
    view.camera = cropped_to(review.swing->student.camera, seen.part, width, height);
    OverlayMoment moment;
    moment.film = shown->image;
    if (bodies.student && film.figures != FigureShow::None) moment.student.emplace(bodies.student->state());
    if (bodies.coach && film.figures == FigureShow::Both) moment.coach.emplace(bodies.coach->state());
    std::optional<OverlayHighlight> highlight;
    if (joint && moment.student && moment.coach) {
      const Vec3 into = glm::transpose(view.camera.rotation_camera_from_world) * Vec3(0, 0, 1);
      if (const auto apart = joint_apart(*moment.student, *moment.coach, joint, into))
        highlight = {apart->student, apart->coach};
    }
    view.scene = make_bodies_scene(moment, palette, view.camera, highlight);
    view.scene.part = seen.part;
    return view;
  });
  const bool fills = seen.on_screen.width >= area.width - 1 && seen.on_screen.height >= area.height - 1;
  ui.texture(texture, seen.on_screen, fills ? radius::kMedium : 0, film.is_mirrored);
  constexpr double kPatience_s = 0.15;
  if (shown->is_wanted_unreadable)
    draw_unreadable(ui, area, film.picture);
  else if (film.says_when_late && shown->frame != film.picture && shown->waited_s > kPatience_s)
    draw_waiting(ui, area, film.picture);
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
  if (state.fits_golfer) state.zoom = golfer_zoom(*first.review, left, state.is_mirrored);
  FilmView view{.name = "film",
                .swing = &first,
                .picture = picture,
                .is_mirrored = state.is_mirrored,
                .zoom = state.zoom,
                .figures = state.figures};
  if (model.compared && !shows_two) view.over = model.compared->review.get();
  const FilmPlace place = draw_film(context, left, view);
  if (!model.compared) return draw_marking(context, place, picture);
  if (!shows_two) {
    draw_marking(context, place, picture);
    const Theme film = make_theme(ThemeKind::Dark, context.theme().palette);
    const std::string other = second_title(model);
    const double half = 0.5 * (area.width - 320);
    const double next = draw_label(ui, area.corner() + Vec2(10), half, first.title, film.student_text);
    (void)draw_label(ui, {next, area.y + 10}, half, other, film.coach_text);
    return;
  }
  const OpenedSwing& second = *model.compared;
  const Rect right = area.column(1, 2, space::kSmall);
  const bool is_mirrored = state.is_mirrored != are_other_handed(*first.review, *second.review);
  (void)draw_film(context, right,
                  {.name = "second film",
                   .swing = &second,
                   .picture = matching_picture(*first.review, *second.review, picture),
                   .is_mirrored = is_mirrored,
                   .zoom = state.fits_golfer ? golfer_zoom(*second.review, right, is_mirrored) : state.zoom,
                   .figures = state.figures});
  draw_marking(context, place, picture);
  // Below: above are the tools.
  const double y = area.bottom() - 34;
  (void)draw_label(ui, {left.x + 10, y}, left.width - 20, first.title);
  (void)draw_label(ui, {right.x + 10, y}, right.width - 20, second_title(model));
}

}  // namespace posecoach
