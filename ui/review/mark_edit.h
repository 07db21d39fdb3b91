// Marking a swing by hand, as plain values: moving its positions, drawing on its pictures, taking it back.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/session/marks.h"
#include "ui/review/playback.h"
#include "ui/review/review_swing.h"

namespace posecoach {

// A drawing in the making.
struct DrawingTool {
  std::optional<DrawingKind> kind;   // what is being drawn; nothing: the pointer moves the film
  std::vector<Vec2> points_px;       // that are there already
  std::optional<Vec2> crosshair_px;  // moved by the keyboard
};
// One more point; the finished drawing when it was the last.
std::optional<Drawing> with_point(DrawingTool& tool, const Vec2& point_px, int picture);

// What can be taken back and done again.
struct MarkHistory {
  std::vector<Marks> before, after;
};
// Remembers `now` before it changes.
void remember(MarkHistory& history, const Marks& now);
std::optional<Marks> undone(MarkHistory& history, const Marks& now);
std::optional<Marks> redone(MarkHistory& history, const Marks& now);

Marks with_event(Marks marks, std::string_view name, int picture);
Marks with_key_picture_toggled(Marks marks, int picture);

// The swing's positions, as analysed: one at this picture, or the nearest one.
int event_near(const ReviewSwing& review, int picture);
// The pictures that a position may be moved to: between its neighbours.
Part room_of_event(const ReviewSwing& review, int event);

// The drawing of this picture that is nearest to a point, if it is within so many pixels.
std::optional<std::size_t> drawing_at(const Marks& marks, int picture, const Vec2& point_px,
                                      double within_px);
// The last one of this picture.
std::optional<std::size_t> last_drawing(const Marks& marks, int picture);

// Positions and key pictures in order: where "before" and "after" stop.
std::vector<int> stops_of(const ReviewSwing& review, const Marks& marks);

}  // namespace posecoach
