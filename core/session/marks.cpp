#include "core/session/marks.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/file.h"
#include "core/session/plain_json.h"

namespace posecoach {
namespace {

constexpr std::string_view kMarksSchema = "marks";
constexpr int kNewest = 1;
constexpr std::size_t kLargestFile = std::size_t{1} << 22;

tl::unexpected<Error> malformed(std::string_view file, const std::string& what) {
  return fail(ErrorCode::Malformed, std::string(file) + ": " + what);
}

const PlainJson* list_in(const PlainJson& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_array() ? &*found : nullptr;
}

bool is_frame(const PlainJson& json) {
  return json.is_number_integer() && json.get<std::int64_t>() >= 0 && json.get<std::int64_t>() < (1 << 30);
}

Result<Drawing> drawing_from(const PlainJson& json, std::string_view file) {
  PlainFields fields(json, file);
  Drawing drawing;
  const auto kind = fields.choice("kind", {"line", "angle"});
  fields.read("frame", drawing.frame);
  if (const Result<void> checked = fields.checked(); !checked) return tl::unexpected(checked.error());
  if (!kind || drawing.frame < 0) return malformed(file, "a drawing needs \"kind\" and \"frame\"");
  drawing.kind = static_cast<DrawingKind>(*kind);
  if (const PlainJson* const points = list_in(json, "points_px"))
    for (const PlainJson& point : *points) {
      if (!point.is_array() || point.size() != 2 || !point[0].is_number() || !point[1].is_number()) break;
      drawing.points_px.emplace_back(point[0].get<double>(), point[1].get<double>());
    }
  if (drawing.points_px.size() != point_count(drawing.kind))
    return malformed(file, "\"points_px\" of a drawing needs " + std::to_string(point_count(drawing.kind)) +
                               " points [x, y]");
  return drawing;
}

}  // namespace

double angle_deg(const Drawing& drawing) {
  if (drawing.kind != DrawingKind::Angle || drawing.points_px.size() != 3) return 0;
  const Vec2 a = drawing.points_px[0] - drawing.points_px[1], b = drawing.points_px[2] - drawing.points_px[1];
  return degrees_from_radians(std::atan2(std::abs(a.x * b.y - a.y * b.x), glm::dot(a, b)));
}

Result<Marks> marks_from_json(std::string_view file_name, std::string_view text) {
  const Result<PlainJson> json = parse_plain_json(file_name, text);
  if (!json) return tl::unexpected(json.error());
  if (const Result<int> version = schema_version(*json, kMarksSchema, kNewest, file_name); !version)
    return tl::unexpected(version.error());
  Marks marks;
  if (const PlainJson* const events = list_in(*json, "events"))
    for (const PlainJson& event : *events) {
      MovedEvent moved;
      PlainFields fields(event, file_name);
      fields.read("name", moved.name);
      fields.read("frame", moved.frame);
      if (const Result<void> checked = fields.checked(); !checked) return tl::unexpected(checked.error());
      if (moved.name.empty() || moved.frame < 0)
        return malformed(file_name, "an event needs \"name\" and \"frame\"");
      marks.events.push_back(std::move(moved));
    }
  if (const PlainJson* const drawings = list_in(*json, "drawings"))
    for (const PlainJson& one : *drawings) {
      Result<Drawing> drawing = drawing_from(one, file_name);
      if (!drawing) return tl::unexpected(drawing.error());
      marks.drawings.push_back(*std::move(drawing));
    }
  if (const PlainJson* const pictures = list_in(*json, "key_pictures"))
    for (const PlainJson& picture : *pictures) {
      if (!is_frame(picture)) return malformed(file_name, "\"key_pictures\" needs numbers of pictures");
      marks.key_pictures.push_back(picture.get<int>());
    }
  std::sort(marks.key_pictures.begin(), marks.key_pictures.end());
  return marks;
}

Result<Marks> read_marks(const Swing& swing) {
  const auto file = swing.file("marks");
  if (!file) return Marks();
  const Result<std::string> text = read_file(*file, kLargestFile);
  if (!text) return tl::unexpected(text.error());
  return marks_from_json(file->string(), *text);
}

std::string marks_to_json(const Marks& marks) {
  PlainJson json{{"schema", "posecoach.marks/1"},
                 {"events", PlainJson::array()},
                 {"drawings", PlainJson::array()},
                 {"key_pictures", marks.key_pictures}};
  for (const MovedEvent& event : marks.events)
    json["events"].push_back({{"name", event.name}, {"frame", event.frame}});
  for (const Drawing& drawing : marks.drawings) {
    PlainJson points = PlainJson::array();
    for (const Vec2& point : drawing.points_px) points.push_back({point.x, point.y});
    json["drawings"].push_back({{"kind", drawing.kind == DrawingKind::Line ? "line" : "angle"},
                                {"frame", drawing.frame},
                                {"points_px", std::move(points)}});
  }
  return to_text(json);
}

}  // namespace posecoach
