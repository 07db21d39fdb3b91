#include <cmath>

#include "ui/panels/review_panels.h"
#include "ui/render/overlay_scene.h"
#include "ui/render/words.h"
#include "ui/report/stills.h"
#include "ui/widgets/controls.h"

namespace posecoach {
namespace {

// Changes whenever the scene does.
std::uint64_t version_of(std::initializer_list<double> values, const void* what) {
  std::uint64_t hash = std::hash<const void*>()(what);
  for (const double value : values)
    hash = hash * 1099511628211ULL + std::hash<double>()(value) + 0x9E3779B97F4A7C15ULL;
  return hash;
}

Vec3 feet_of(const PosedBody& body) {
  Vec3 sum(0);
  double count = 0;
  for (const HumanoidJoint role : {HumanoidJoint::LeftAnkle, HumanoidJoint::RightAnkle})
    if (const int joint = body.skeleton->find(role); joint != kNoJoint) {
      sum += body.positions[static_cast<std::size_t>(joint)];
      count += 1;
    }
  return count > 0 ? sum / count : Vec3(0);
}

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

void draw_label(Ui& ui, const Rect& place, std::string_view words) {
  const Pill pill{words, colour_from_hex(0xF3F6FA), colour_from_hex(0x0C1016).with_alpha(0.78F)};
  draw_pill(ui, {place.x + 10, place.y + 10, std::min(pill_width(ui, pill), place.width - 20), 24}, pill);
}

}  // namespace

FilmMarks marks_of(const ReviewSwing& review) {
  return {review.times_s, review.events};
}

int shown_picture(const PanelContext& context) {
  const int count = context.model.opened ? context.model.opened->review->picture_count() : 0;
  return std::clamp(context.state.playback.frame, 0, std::max(0, count - 1));
}

void draw_film(const PanelContext& context, const Rect& area, const FilmView& film) {
  Ui& ui = context.ui;
  ui.fill(area, colour_from_hex(0x07090C), radius::kMedium);
  const ReviewSwing& review = *film.swing->review;
  const std::optional<ShownPicture> shown =
      film.swing->picture ? film.swing->picture(film.picture) : std::nullopt;
  const PoseTrack& track = review.swing->track;
  const Rect place = fitted(track.width, track.height, area);
  if (!shown || !shown->image) {
    const double angle = 4 * ui.time_s();
    ui.arc(area.centre(), 14, angle, angle + 1.6, colour_from_hex(0xA9B5C4), 3);
    return;
  }
  const double wanted = place.width * place.height * ui.scale() * ui.scale();
  const double factor =
      ui.scale() * std::min(1.0, std::sqrt(ui.views().most_pixels() / std::max(1.0, wanted)));
  const int width = std::max(16, static_cast<int>(std::lround(place.width * factor))),
            height = std::max(16, static_cast<int>(std::lround(place.height * factor)));
  const Palette palette = context.theme().palette;
  const std::optional<HumanoidJoint> joint =
      film.over ? std::nullopt : advised_joint(review.analysis(), context.state.chosen_advice, shown->frame);
  const std::uint64_t version =
      version_of({1.0 * shown->frame, 1.0 * width, 1.0 * height, palette == Palette::RedGreen ? 0.0 : 1.0,
                  film.over ? 1.0 : 0.0, joint ? static_cast<double>(*joint) : -1.0},
                 shown->image.get());
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
  ui.texture(texture, place,
             place.width >= area.width - 1 && place.height >= area.height - 1 ? radius::kMedium : 0,
             film.is_mirrored);
}

void draw_films(const PanelContext& context, const Rect& area) {
  Ui& ui = context.ui;
  const WindowModel& model = context.model;
  if (!model.opened) return;
  const int picture = shown_picture(context);
  const OpenedSwing& first = *model.opened;
  if (!model.compared) return draw_film(context, area, {.name = "film", .swing = &first, .picture = picture});
  const OpenedSwing& second = *model.compared;
  if (context.state.compare == CompareLook::Superposed) {
    draw_film(context, area,
              {.name = "film", .swing = &first, .picture = picture, .over = second.review.get()});
    return draw_label(ui, area, first.title + "  over  " + second.title);
  }
  const Rect left = area.column(0, 2, space::kSmall), right = area.column(1, 2, space::kSmall);
  draw_film(context, left, {.name = "film", .swing = &first, .picture = picture});
  draw_film(context, right,
            {.name = "second film",
             .swing = &second,
             .picture = matching_picture(*first.review, *second.review, picture)});
  draw_label(ui, left, first.title);
  draw_label(ui, right, second.title);
}

void draw_bodies(const PanelContext& context, const Rect& area) {
  if (!context.model.opened) return;
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  WindowState& state = context.state;
  const ReviewSwing& review = *context.model.opened->review;
  const bool is_dark = theme.kind == ThemeKind::Dark;
  const Interaction on = ui.region("bodies", area, Focus::Never);
  state.orbit = dragged(state.orbit, on.drag, on.wheel);
  const int picture = shown_picture(context);
  const int width = std::max(16, static_cast<int>(std::lround(area.width * ui.scale()))),
            height = std::max(16, static_cast<int>(std::lround(area.height * ui.scale())));
  const std::uint64_t version =
      version_of({1.0 * picture, 1.0 * width, 1.0 * height, state.orbit.turn, state.orbit.rise,
                  state.orbit.closeness, theme.palette == Palette::RedGreen ? 0.0 : 1.0, is_dark ? 0.0 : 1.0},
                 &review);
  const TextureName texture = ui.views().scene("bodies", version, [&] {
    const BodiesAtPicture bodies = bodies_at(review, picture);
    SceneView view;
    Scene& scene = view.scene;
    scene.background_top = colour_from_hex(is_dark ? 0x222A35 : 0xF7F9FB);
    scene.background_bottom = colour_from_hex(is_dark ? 0x12161C : 0xDDE3EA);
    Vec3 feet(0);
    const int address = review.events.empty() ? review.swing->student.first_frame : review.events.front();
    if (const auto body = bodies_at(review, address).student) feet = feet_of(*body);
    feet.y = 0;
    Floor floor;
    floor.centre = feet;
    floor.line = colour_from_hex(is_dark ? 0x8A94A6 : 0x7F8C9C).with_alpha(is_dark ? 0.35F : 0.5F);
    scene.floor = floor;
    const double outline_px = std::max(1.0, 1.2 * ui.scale());
    const auto add = [&](const std::optional<PosedBody>& body, FigureStyle style) {
      if (!body) return;
      style.outline_px = outline_px;
      scene.figures.push_back(make_figure(body->state(), style));
    };
    add(bodies.coach, coach_style(theme.palette));
    add(bodies.student, student_style(theme.palette));
    view.camera = orbit_camera(state.orbit, feet, review.swing->student.body.rest_height() + 0.12,
                               review.front, width, height);
    return view;
  });
  ui.texture(texture, area, radius::kMedium);
  ui.outline(area, theme.line, radius::kMedium);
  struct Side {
    std::string_view words, hint;
    Orbit orbit;
  };
  const std::array<Side, 3> views = {{{"Front", "From the front (F)", kFrontOrbit},
                                      {"Side", "Down the line (D)", kSideOrbit},
                                      {"Top", "From above (T)", kTopOrbit}}};
  Rect row = area.inset(8);
  row = row.take_bottom(28);
  for (int i = 0; i < 3; ++i) {
    const Side& view = views[static_cast<std::size_t>(i)];
    const Rect place = row.column(i, 3, 4);
    const Interaction press = ui.region(view.words, place);
    const bool is_chosen = state.orbit == view.orbit;
    ui.fill(place, is_chosen ? chosen_paper(theme) : theme.raised.with_alpha(press.hovered ? 1 : 0.85F),
            radius::kSmall);
    ui.text_in(TextStyle::Caption, place, view.words, is_chosen ? theme.text : theme.quiet, Align::Centre);
    ui.focus_ring(place, radius::kSmall, press);
    ui.tooltip(place, press, view.hint);
    if (press.hovered) ui.use_hand_pointer();
    if (press.clicked) state.orbit = view.orbit;
  }
}

}  // namespace posecoach
