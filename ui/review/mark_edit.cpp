#include "ui/review/mark_edit.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace posecoach {
namespace {

constexpr std::size_t kMostKept = 200;

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double length = glm::dot(along, along);
  const double at = length > 0 ? std::clamp(glm::dot(p - a, along) / length, 0.0, 1.0) : 0;
  return glm::distance(p, a + at * along);
}

std::optional<Marks> moved_between(std::vector<Marks>& from, std::vector<Marks>& to, const Marks& now) {
  if (from.empty()) return std::nullopt;
  to.push_back(now);
  Marks back = std::move(from.back());
  from.pop_back();
  return back;
}

}  // namespace

std::optional<Drawing> with_point(DrawingTool& tool, const Vec2& point_px, int picture) {
  if (!tool.kind) return std::nullopt;
  // Two points in one place are one.
  if (!tool.points_px.empty() && glm::distance(tool.points_px.back(), point_px) < 1) return std::nullopt;
  tool.points_px.push_back(point_px);
  if (tool.points_px.size() < point_count(*tool.kind)) return std::nullopt;
  Drawing drawing{*tool.kind, picture, std::move(tool.points_px)};
  tool = {};
  return drawing;
}

void remember(MarkHistory& history, const Marks& now) {
  history.before.push_back(now);
  if (history.before.size() > kMostKept) history.before.erase(history.before.begin());
  history.after.clear();
}

std::optional<Marks> undone(MarkHistory& history, const Marks& now) {
  return moved_between(history.before, history.after, now);
}

std::optional<Marks> redone(MarkHistory& history, const Marks& now) {
  return moved_between(history.after, history.before, now);
}

Marks with_event(Marks marks, std::string_view name, int picture) {
  for (MovedEvent& event : marks.events)
    if (event.name == name) {
      event.frame = picture;
      return marks;
    }
  marks.events.push_back({std::string(name), picture});
  return marks;
}

Marks with_key_picture_toggled(Marks marks, int picture) {
  std::vector<int>& pictures = marks.key_pictures;
  const auto found = std::lower_bound(pictures.begin(), pictures.end(), picture);
  if (found != pictures.end() && *found == picture)
    pictures.erase(found);
  else
    pictures.insert(found, picture);
  return marks;
}

int event_near(const ReviewSwing& review, int picture) {
  int best = -1;
  for (int i = 0; i < static_cast<int>(review.events.size()); ++i) {
    const auto far = [&](int event) {
      return std::abs(review.events[static_cast<std::size_t>(event)] - picture);
    };
    if (best < 0 || far(i) < far(best)) best = i;
  }
  return best;
}

Part room_of_event(const ReviewSwing& review, int event) {
  const auto at = [&](int i) { return review.events[static_cast<std::size_t>(i)]; };
  const int count = static_cast<int>(review.events.size());
  const LiftedStudent& student = review.swing->student;
  const int first = student.first_frame, last = first + student.motion.frame_count() - 1;
  const int from = event > 0 ? at(event - 1) + 1 : first, to = event + 1 < count ? at(event + 1) - 1 : last;
  return {from, std::max(from, to)};
}

std::optional<std::size_t> drawing_at(const Marks& marks, int picture, const Vec2& point_px,
                                      double within_px) {
  std::optional<std::size_t> best;
  double nearest = within_px;
  for (std::size_t i = 0; i < marks.drawings.size(); ++i) {
    const Drawing& drawing = marks.drawings[i];
    if (drawing.frame != picture) continue;
    for (std::size_t k = 1; k < drawing.points_px.size(); ++k) {
      const double distance = distance_to_segment(point_px, drawing.points_px[k - 1], drawing.points_px[k]);
      if (distance > nearest) continue;
      nearest = distance;
      best = i;
    }
  }
  return best;
}

std::optional<std::size_t> last_drawing(const Marks& marks, int picture) {
  for (std::size_t i = marks.drawings.size(); i-- > 0;)
    if (marks.drawings[i].frame == picture) return i;
  return std::nullopt;
}

std::vector<int> stops_of(const ReviewSwing& review, const Marks& marks) {
  std::vector<int> stops = review.events;
  stops.insert(stops.end(), marks.key_pictures.begin(), marks.key_pictures.end());
  std::sort(stops.begin(), stops.end());
  stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
  return stops;
}

}  // namespace posecoach
