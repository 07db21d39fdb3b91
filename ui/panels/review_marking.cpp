// What is drawn on a film by hand, and how the pointer and the keyboard do it.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "ui/panels/review_film_view.h"
#include "ui/panels/review_panels.h"
#include "ui/render/words.h"
#include "ui/widgets/controls.h"

namespace posecoach {
namespace {

constexpr double kReach = 9;        // of the pointer, points
constexpr double kDragged = 6;      // from which on a press is a drag
constexpr double kZoomStep = 1.25;  // of a key
const Colour kInk = colour_from_hex(0xFFD84D), kEdge = colour_from_hex(0x0C1016).with_alpha(0.75F);

void draw_stroke(Ui& ui, const Vec2& a, const Vec2& b, double width) {
  ui.line(a, b, kEdge, width + 2.5);
  ui.line(a, b, kInk, width);
}

void draw_angle_sign(Ui& ui, const Drawing& drawing, std::span<const Vec2> at) {
  const Vec2 a = at[0] - at[1], b = at[2] - at[1];
  const double radius = std::min({0.5 * glm::length(a), 0.5 * glm::length(b), 34.0});
  if (radius < 2) return;
  // From twelve o'clock, clockwise, the short way round.
  const double from = std::atan2(a.x, -a.y), turn = std::remainder(std::atan2(b.x, -b.y) - from, 2 * kPi);
  ui.arc(at[1], radius, std::min(from, from + turn), std::max(from, from + turn), kInk, 2);
  const double middle = from + 0.5 * turn;
  const std::string words = decimal(angle_deg(drawing), 0) + "°";
  const Pill pill{words, kInk, kEdge};
  const double width = pill_width(ui, pill);
  const Vec2 centre = at[1] + (radius + 8 + 0.5 * width) * Vec2(std::sin(middle), -std::cos(middle));
  draw_pill(ui, {centre.x - 0.5 * width, centre.y - 11, width, 22}, pill);
}

void draw_drawing(Ui& ui, const FilmPlace& place, const Drawing& drawing, bool is_chosen) {
  std::vector<Vec2> at;
  for (const Vec2& point : drawing.points_px) at.push_back(place.screen_from_film(point));
  for (std::size_t i = 1; i < at.size(); ++i) draw_stroke(ui, at[i - 1], at[i], is_chosen ? 4 : 2.6);
  if (drawing.kind == DrawingKind::Angle && at.size() == 3) draw_angle_sign(ui, drawing, at);
  for (const Vec2& point : at) {
    ui.disc(point, is_chosen ? 6 : 4, kEdge);
    ui.disc(point, is_chosen ? 4.5 : 2.8, is_chosen ? colour_from_hex(0xFFFFFF) : kInk);
  }
}

void add_point(const PanelContext& context, const Vec2& point_px, int picture) {
  WindowState& state = context.state;
  std::optional<Drawing> finished = with_point(state.tool, point_px, picture);
  if (!finished) return;
  Marks marks = context.model.opened->marks;
  marks.drawings.push_back(*std::move(finished));
  state.chosen_drawing = marks.drawings.size() - 1;
  set_marks(context, std::move(marks));
}

void choose_tool(const PanelContext& context, DrawingKind kind) {
  WindowState& state = context.state;
  const bool is_on = state.tool.kind == kind;
  state.tool = {};
  state.chosen_drawing.reset();
  if (is_on) return;
  state.tool.kind = kind;
  state.playback.is_playing = false;
}

void delete_drawing(const PanelContext& context) {
  Marks marks = context.model.opened->marks;
  std::optional<std::size_t> which = context.state.chosen_drawing;
  if (!which || *which >= marks.drawings.size()) which = last_drawing(marks, shown_picture(context));
  context.state.chosen_drawing.reset();
  if (!which) return;
  marks.drawings.erase(marks.drawings.begin() + static_cast<std::ptrdiff_t>(*which));
  set_marks(context, std::move(marks));
}

void take_back(const PanelContext& context) {
  if (auto before = undone(context.state.history, context.model.opened->marks))
    context.want(intent::SetMarks{context.model.opened->id, *std::move(before)});
  context.state.chosen_drawing.reset();
}

// The arrows move a crosshair, Enter puts a point.
void use_crosshair_keys(const PanelContext& context) {
  Ui& ui = context.ui;
  DrawingTool& tool = context.state.tool;
  const PoseTrack& track = context.model.opened->review->swing->track;
  const Vec2 size(track.width, track.height);
  if (context.pressed(Command::Back)) {
    tool = {};
    return;
  }
  for (const auto& [key, direction] : {std::pair(Key::Left, Vec2(-1, 0)), std::pair(Key::Right, Vec2(1, 0)),
                                       std::pair(Key::Up, Vec2(0, -1)), std::pair(Key::Down, Vec2(0, 1))})
    for (const bool is_fine : {false, true})
      while (ui.take_key({key, is_fine}, Repeats::Count)) {
        const double step = (is_fine ? 0.002 : 0.015) * size.y;
        const double mirror = context.state.is_mirrored && direction.x != 0 ? -1 : 1;
        tool.crosshair_px =
            glm::clamp(tool.crosshair_px.value_or(0.5 * size) + mirror * step * direction, Vec2(0), size);
      }
  if (tool.crosshair_px && ui.take_key({Key::Enter})) {
    const Vec2 at = *tool.crosshair_px;
    add_point(context, at, shown_picture(context));
    if (tool.kind) tool.crosshair_px = at;
  }
}

constexpr double kTool = 34, kToolGap = 2, kZoomWide = 58;
constexpr int kTools = 6;

void zoom_by_hand(WindowState& state, const FilmZoom& zoom) {
  state.fits_golfer = false;
  state.zoom = zoom;
}

void toggle_golfer(WindowState& state) {
  state.fits_golfer = !state.fits_golfer;
  if (!state.fits_golfer) state.zoom = {};
}

// Where the tools lie on the film; empty where there is no room for them.
Rect tools_area(const FilmPlace& place) {
  const double width = kTools * kTool + (kTools - 1) * kToolGap + kZoomWide + 8;
  if (place.area.width < width + 20) return {};
  return {place.area.right() - width - 8, place.area.y + 8, width, kTool + 8};
}

void use_pointer(const PanelContext& context, const FilmPlace& place, int picture) {
  Ui& ui = context.ui;
  WindowState& state = context.state;
  const Interaction on = ui.region("film", place.area, Focus::Never);
  if (on.wheel != 0) zoom_by_hand(state, zoomed(state.zoom, std::exp(0.14 * on.wheel), on.mouse, place));
  const Vec2 at = place.film_from_screen(on.mouse);
  if (state.tool.kind) {
    if (on.hovered && on.drag == Vec2(0) && !on.pressed && glm::length(ui.mouse_moved()) > 0)
      state.tool.crosshair_px.reset();
    if (tools_area(place).contains(on.mouse)) return;
    if (on.pressed) {
      add_point(context, at, picture);
    } else if (on.released && !state.tool.points_px.empty() &&
               glm::distance(place.screen_from_film(state.tool.points_px.back()), on.mouse) > kDragged) {
      add_point(context, at, picture);
    }
    return;
  }
  if (on.held && on.drag != Vec2(0) && state.zoom.factor > 1)
    zoom_by_hand(state, panned(state.zoom, on.drag, place));
  if (on.clicked)
    state.chosen_drawing = drawing_at(context.model.opened->marks, picture, at, kReach / place.scale());
}

// What is still being drawn, up to the pointer.
void draw_unfinished(const PanelContext& context, const FilmPlace& place, int picture) {
  Ui& ui = context.ui;
  const DrawingTool& tool = context.state.tool;
  if (!tool.kind) return;
  const bool has_pointer = place.area.contains(ui.mouse());
  const std::optional<Vec2> end = tool.crosshair_px ? tool.crosshair_px
                                  : has_pointer     ? std::optional(place.film_from_screen(ui.mouse()))
                                                    : std::nullopt;
  Drawing drawing{*tool.kind, picture, tool.points_px};
  if (end) drawing.points_px.push_back(*end);
  draw_drawing(ui, place, drawing, true);
  if (tool.crosshair_px) {
    const Vec2 at = place.screen_from_film(*tool.crosshair_px);
    for (const Vec2& arm : {Vec2(1, 0), Vec2(0, 1)}) {
      draw_stroke(ui, at - 16.0 * arm, at - 6.0 * arm, 1.6);
      draw_stroke(ui, at + 6.0 * arm, at + 16.0 * arm, 1.6);
    }
  }
  const std::size_t left = point_count(*tool.kind) - tool.points_px.size();
  const std::string_view words = *tool.kind == DrawingKind::Line
                                     ? (left == 2 ? "Press where the line begins" : "Press where it ends")
                                     : (left == 3   ? "Press at the end of the first leg"
                                        : left == 2 ? "Press at the corner"
                                                    : "Press at the end of the second leg");
  const std::string all = std::string(words) + "; arrows and Enter do it too, Esc ends it";
  const Pill pill{all, colour_from_hex(0xF3F6FA), colour_from_hex(0x0C1016).with_alpha(0.82F)};
  const double width = std::min(pill_width(ui, pill), place.area.width - 20);
  draw_pill(ui, {place.area.centre().x - 0.5 * width, place.area.bottom() - 38, width, 26}, pill);
}

void draw_tools(const PanelContext& context, const FilmPlace& place, int picture) {
  Ui& ui = context.ui;
  WindowState& state = context.state;
  const Marks& marks = context.model.opened->marks;
  const ThemeScope scope(ui, film_theme(context.theme()));
  const Rect bar = tools_area(place);
  if (bar.is_empty()) return;
  const bool is_key = std::binary_search(marks.key_pictures.begin(), marks.key_pictures.end(), picture);
  const bool can_delete = state.chosen_drawing.has_value() || last_drawing(marks, picture).has_value();
  const std::string zoom_words = decimal(state.zoom.factor, 1) + "×";
  ui.fill(bar, colour_from_hex(0x0C1016).with_alpha(0.74F), radius::kMedium);
  Rect row = bar.inset(4);
  const auto tool = [&](std::string_view id, Icon icon, std::string_view words, Command command, bool is_on,
                        bool is_enabled = true) {
    const std::string hint = context.hint(words, command);
    return draw_button(ui, row.take_left(kTool, kToolGap),
                       {.id = id,
                        .icon = icon,
                        .look = ButtonLook::Quiet,
                        .hint = hint,
                        .is_on = is_on,
                        .is_enabled = is_enabled});
  };
  const std::string zoom_hint = context.hint(
      state.fits_golfer ? "The whole film" : "The golfer as large as he fits", Command::ToggleGolfer);
  if (draw_button(ui, row.take_left(kZoomWide, 0),
                  {.id = "zoom",
                   .words = zoom_words,
                   .look = ButtonLook::Quiet,
                   .hint = zoom_hint,
                   .is_on = state.fits_golfer}))
    toggle_golfer(state);
  const std::string_view figures = state.figures == FigureShow::Both      ? "Your skeleton only"
                                   : state.figures == FigureShow::Student ? "The film alone"
                                                                          : "Both skeletons";
  if (tool("figures", Icon::Body, figures, Command::ChangeFigures, state.figures != FigureShow::None))
    change_figures(state);
  if (tool("draw line", Icon::Line, "Draw a line", Command::DrawLine, state.tool.kind == DrawingKind::Line))
    choose_tool(context, DrawingKind::Line);
  if (tool("draw angle", Icon::Angle, "Draw an angle", Command::DrawAngle,
           state.tool.kind == DrawingKind::Angle))
    choose_tool(context, DrawingKind::Angle);
  if (tool("key picture", Icon::Bookmark, is_key ? "No key picture" : "Key picture", Command::KeyImage,
           is_key))
    set_marks(context, with_key_picture_toggled(marks, picture));
  if (tool("delete drawing", Icon::Trash, "Delete the drawing", Command::DeleteDrawing, false, can_delete))
    delete_drawing(context);
  if (tool("undo", Icon::Undo, "Undo", Command::Undo, false, !state.history.before.empty()))
    take_back(context);
}

}  // namespace

void change_figures(WindowState& state) {
  state.figures = static_cast<FigureShow>((static_cast<int>(state.figures) + 1) % 3);
}

void set_marks(const PanelContext& context, Marks marks) {
  remember(context.state.history, context.model.opened->marks);
  context.want(intent::SetMarks{context.model.opened->id, std::move(marks)});
}

void use_marking_keys(const PanelContext& context) {
  WindowState& state = context.state;
  const OpenedSwing& swing = *context.model.opened;
  const PoseTrack& track = swing.review->swing->track;
  if (state.tool.kind) use_crosshair_keys(context);
  if (context.pressed(Command::DrawLine)) choose_tool(context, DrawingKind::Line);
  if (context.pressed(Command::DrawAngle)) choose_tool(context, DrawingKind::Angle);
  if (context.pressed(Command::DeleteDrawing)) delete_drawing(context);
  if (context.pressed(Command::KeyImage))
    set_marks(context, with_key_picture_toggled(swing.marks, shown_picture(context)));
  if (context.pressed(Command::Undo)) take_back(context);
  if (context.pressed(Command::Redo))
    if (auto again = redone(state.history, swing.marks))
      context.want(intent::SetMarks{swing.id, *std::move(again)});
  const FilmPlace place = place_film(state.film_area, track.width, track.height, state.zoom);
  const Vec2 middle = place.area.centre();
  if (context.pressed(Command::ZoomIn)) zoom_by_hand(state, zoomed(state.zoom, kZoomStep, middle, place));
  if (context.pressed(Command::ZoomOut))
    zoom_by_hand(state, zoomed(state.zoom, 1 / kZoomStep, middle, place));
  if (context.pressed(Command::ZoomWhole)) zoom_by_hand(state, {});
  if (context.pressed(Command::ToggleGolfer)) toggle_golfer(state);
  if (context.pressed(Command::ChangeFigures)) change_figures(state);
}

void draw_marking(const PanelContext& context, const FilmPlace& place, int picture) {
  Ui& ui = context.ui;
  const Marks& marks = context.model.opened->marks;
  use_pointer(context, place, picture);
  {
    const ClipScope clip(ui, place.area);
    for (std::size_t i = 0; i < marks.drawings.size(); ++i)
      if (marks.drawings[i].frame == picture)
        draw_drawing(ui, place, marks.drawings[i], context.state.chosen_drawing == i);
    draw_unfinished(context, place, picture);
  }
  draw_tools(context, place, picture);
}

}  // namespace posecoach
