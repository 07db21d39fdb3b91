#include "ui/panels/review_events.h"

#include <algorithm>

#include "ui/panels/review_film_view.h"
#include "ui/panels/review_panels.h"
#include "ui/render/words.h"

namespace posecoach {
namespace {

const std::string& name_of(const OpenedSwing& swing, std::size_t event) {
  return swing.review->analysis().student_events[event].name;
}

void move_event(const PanelContext& context, int event, int picture) {
  const OpenedSwing& swing = *context.model.opened;
  const auto i = static_cast<std::size_t>(event);
  if (i >= swing.review->events.size() || picture == swing.review->events[i]) return;
  set_marks(context, with_event(swing.marks, name_of(swing, i), picture));
}

int kept_in(const Part& room, int picture) {
  return std::clamp(picture, room.first, room.last);
}

void show(const PanelContext& context, int picture) {
  WindowState& state = context.state;
  state.playback = moved_to(state.playback, picture, marks_of(*context.model.opened->review));
}

}  // namespace

bool is_moved_by_hand(const OpenedSwing& swing, std::size_t event) {
  return std::any_of(swing.marks.events.begin(), swing.marks.events.end(),
                     [&](const MovedEvent& moved) { return moved.name == name_of(swing, event); });
}

void draw_event_handles(const PanelContext& context, const EventRow& row) {
  Ui& ui = context.ui;
  const Theme& theme = context.theme();
  WindowState& state = context.state;
  const OpenedSwing& swing = *context.model.opened;
  const ReviewSwing& review = *swing.review;
  const IdScope scope(ui, "event handles");
  std::optional<std::pair<int, int>> dragged;
  for (std::size_t i = 0; i < review.events.size(); ++i) {
    const int event = static_cast<int>(i);
    const bool is_dragged = state.dragged_event && state.dragged_event->first == event;
    const int picture = is_dragged ? state.dragged_event->second : review.events[i];
    const double x = row.x_of(picture);
    const Rect place{x - 9, row.y - 12, 18, 24};
    const Interaction on = ui.region(std::to_string(i), place, Focus::Never);
    const bool is_moved = is_moved_by_hand(swing, i);
    const double half = on.hovered || on.held ? 6.5 : 5;
    const std::array<Vec2, 4> diamond = {Vec2(x, row.y - half - 1.5), Vec2(x + half, row.y),
                                         Vec2(x, row.y + half + 1.5), Vec2(x - half, row.y)};
    ui.polygon(diamond, is_moved ? theme.accent : theme.surface.with_alpha(1));
    std::vector<Vec2> edge(diamond.begin(), diamond.end());
    edge.push_back(diamond[0]);
    edge.push_back(diamond[1]);
    ui.polyline(edge, is_moved ? theme.text : theme.student_text, 1.6);
    if (on.hovered) ui.use_hand_pointer();
    const std::string hint = title_from_name(name_of(swing, i)) +
                             (is_moved ? ", moved by hand; drag it" : ": drag it to its true place");
    ui.tooltip(place, on, hint);
    if (on.held) {
      // A press alone goes there; dragging moves it.
      const bool is_drag = is_dragged || std::abs(on.mouse.x - x) > 4;
      const int wanted =
          is_drag ? kept_in(room_of_event(review, event), row.picture_at(on.mouse.x)) : picture;
      if (is_drag) dragged = {event, wanted};
      show(context, wanted);
    }
    if (on.released && is_dragged) move_event(context, event, picture);
  }
  state.dragged_event = dragged;
}

void use_event_keys(const PanelContext& context) {
  const ReviewSwing& review = *context.model.opened->review;
  for (const auto& [command, by] :
       {std::pair(Command::EventEarlier, -1), std::pair(Command::EventLater, 1)}) {
    if (!context.pressed(command)) continue;
    const int event = event_near(review, shown_picture(context));
    if (event < 0) continue;
    const int picture =
        kept_in(room_of_event(review, event), review.events[static_cast<std::size_t>(event)] + by);
    move_event(context, event, picture);
    show(context, picture);
  }
}

void put_events_back(const PanelContext& context) {
  Marks marks = context.model.opened->marks;
  marks.events.clear();
  set_marks(context, std::move(marks));
}

}  // namespace posecoach
