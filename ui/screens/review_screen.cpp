#include <algorithm>

#include "ui/panels/review_events.h"
#include "ui/panels/review_film_view.h"
#include "ui/panels/review_panels.h"
#include "ui/screens/key_map.h"
#include "ui/screens/screens.h"
#include "ui/widgets/controls.h"

namespace posecoach {
namespace {

// Another swing starts at its beginning, with the first advice to be seen.
void adopt_swing(const PanelContext& context) {
  WindowState& state = context.state;
  const auto& review = context.model.opened->review;
  if (state.played == review) return;
  state.played = review;
  // The same swing, analysed anew or kept by now: the user stays where he is.
  const std::string& id = context.model.opened->id;
  const bool is_same = !id.empty() && state.played_id == id;
  state.played_id = id;
  if (is_same) {
    state.chosen_advice =
        std::min(state.chosen_advice, static_cast<int>(review->analysis().advice.size()) - 1);
    return;
  }
  state.zoom = {};
  state.fits_golfer = true;
  state.tool = {};
  state.history = {};
  state.chosen_drawing.reset();
  const double speed = state.playback.speed;
  state.playback = Playback{.speed = speed};
  state.chosen_advice = -1;
  state.orbit = kFrontOrbit;
  const FilmMarks film = marks_of(*review);
  state.playback = moved_to(state.playback, film.events.empty() ? 0 : film.events[0], film);
}

void use_keys(const PanelContext& context) {
  Ui& ui = context.ui;
  WindowState& state = context.state;
  const ReviewSwing& review = *context.model.opened->review;
  use_marking_keys(context);
  use_event_keys(context);
  const std::vector<int> stops = stops_of(review, context.model.opened->marks);
  FilmMarks film = marks_of(review);
  film.stops = stops;
  state.playback = played_by_keys(ui, context.model.keys, state.playback, film);
  if (context.pressed(Command::Mirror)) state.is_mirrored = !state.is_mirrored;
  if (context.pressed(Command::Snapshot)) context.want(intent::KeepShown{state.film_area});
  if (context.pressed(Command::TurnLeft)) state.orbit = turned_by_step(state.orbit, -1);
  if (context.pressed(Command::TurnRight)) state.orbit = turned_by_step(state.orbit, 1);
  if (context.pressed(Command::FrontView)) state.orbit = kFrontOrbit;
  if (context.pressed(Command::SideView)) state.orbit = kSideOrbit;
  if (context.pressed(Command::TopView)) state.orbit = kTopOrbit;
  const int count = static_cast<int>(review.analysis().advice.size());
  if (context.pressed(Command::NextAdvice) && count > 0)
    show_advice(context, (state.chosen_advice + 1) % count);
  if (context.pressed(Command::PreviousAdvice) && count > 0)
    show_advice(context, (std::max(0, state.chosen_advice) + count - 1) % count);
  for (const auto& [command, look] : {std::pair(Command::SideBySide, CompareLook::SideBySide),
                                      std::pair(Command::Superpose, CompareLook::Superposed)}) {
    if (!context.pressed(command)) continue;
    state.compare = look;
    if (context.model.compared) continue;
    state.is_picking_second = true;
    state.screen = ScreenName::Library;
  }
  if (context.pressed(Command::ToggleStar))
    context.want(intent::SetStar{context.model.opened->id, !context.model.opened->is_starred});
  if (context.pressed(Command::Back)) {
    if (context.model.compared)
      context.want(intent::StopComparing{});
    else
      state.screen = ScreenName::Library;
  }
}

}  // namespace

void draw_review_screen(const PanelContext& context, const Rect& area) {
  Ui& ui = context.ui;
  ui.fill(area, context.theme().background);
  if (!context.model.opened) {
    draw_empty(ui, area, Icon::Review, "No swing is open",
               "Make a swing on the Live screen, or choose one in the Library.");
    const Rect button{area.centre().x - 80, area.centre().y + 90, 160, 38};
    if (draw_button(ui, button,
                    {.id = "to library",
                     .words = "Open Library",
                     .icon = Icon::Library,
                     .look = ButtonLook::Primary}))
      context.state.screen = ScreenName::Library;
    return;
  }
  adopt_swing(context);
  use_keys(context);
  WindowState& state = context.state;
  state.playback = advanced(state.playback, ui.elapsed_s(), marks_of(*context.model.opened->review));

  Rect rest = area.inset(14, 12);
  draw_review_header(context, rest.take_top(36, 10));
  const double timeline = std::clamp(0.36 * rest.height, 190.0, 400.0);
  draw_timeline(context, rest.take_bottom(timeline, 8));
  draw_transport(context, rest.take_bottom(42, 8));
  draw_advice(context, rest.take_right(std::clamp(0.25 * rest.width, 290.0, 420.0), 12));
  const bool shows_two = context.model.compared && state.compare == CompareLook::SideBySide;
  if (!shows_two) draw_bodies(context, rest.take_right(std::clamp(0.27 * rest.width, 200.0, 560.0), 12));
  draw_films(context, rest);
}

}  // namespace posecoach
