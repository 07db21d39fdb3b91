#include <array>
#include <cmath>

#include "ui/panels/review_film_view.h"
#include "ui/panels/review_panels.h"
#include "ui/widgets/controls.h"

namespace posecoach {

std::uint64_t scene_version(std::initializer_list<double> values, const void* what) {
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
  const std::uint64_t version = scene_version(
      {1.0 * picture, 1.0 * width, 1.0 * height, state.orbit.turn, state.orbit.rise, state.orbit.closeness,
       theme.palette == Palette::RedGreen ? 0.0 : 1.0, is_dark ? 0.0 : 1.0},
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
    Command command;
    Orbit orbit;
  };
  const std::array<Side, 3> views = {{{"Front", "From the front", Command::FrontView, kFrontOrbit},
                                      {"Side", "Down the line", Command::SideView, kSideOrbit},
                                      {"Top", "From above", Command::TopView, kTopOrbit}}};
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
    ui.tooltip(place, press, context.hint(view.hint, view.command));
    if (press.hovered) ui.use_hand_pointer();
    if (press.clicked) state.orbit = view.orbit;
  }
}

}  // namespace posecoach
