// What somebody marked on a swing by hand: positions put in their place, lines and angles drawn on the film,
// pictures worth looking at. Kept beside the film in marks.json ("posecoach.marks/1"), never in it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/coaching/moved_events.h"
#include "core/session/swing.h"

namespace posecoach {

enum class DrawingKind { Line, Angle };

struct Drawing {
  DrawingKind kind = DrawingKind::Line;
  int frame = 0;  // of the film
  // Pixels of the film. Of a line both ends; of an angle the end of a leg, the corner, the end of the other.
  std::vector<Vec2> points_px;
  bool operator==(const Drawing&) const = default;
};
constexpr std::size_t point_count(DrawingKind kind) {
  return kind == DrawingKind::Line ? 2 : 3;
}
// Between the legs, 0 to 180 degrees; 0 for a line.
double angle_deg(const Drawing& drawing);

struct Marks {
  std::vector<MovedEvent> events;  // frames of the film
  std::vector<Drawing> drawings;
  std::vector<int> key_pictures;  // rising
  bool operator==(const Marks&) const = default;
};

inline constexpr const char* kMarksFile = "marks.json";

// The swing's; none where it has no such file. Errors: those of files; Malformed with file; Unsupported (made
// by a newer version).
Result<Marks> read_marks(const Swing& swing);
Result<Marks> marks_from_json(std::string_view file_name, std::string_view text);
std::string marks_to_json(const Marks& marks);

}  // namespace posecoach
