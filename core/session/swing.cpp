#include "core/session/swing.h"

#include "core/base/file.h"
#include "core/session/plain_json.h"

namespace posecoach {
namespace fs = std::filesystem;
namespace {

constexpr const char* kSwingSchema = "swing";
constexpr int kNewest = 1;

void read_counters(PlainFields& fields, RecordingCounters& counters) {
  fields.read("captured", counters.captured);
  fields.read("lost_by_camera", counters.lost_by_camera);
  fields.read("lost_by_recorder", counters.lost_by_recorder);
  fields.read("skipped_by_pose", counters.skipped_by_pose);
}

void read_facts(PlainFields& fields, SwingFacts& facts) {
  std::string recorded_at;
  fields.read("recorded_at", recorded_at);
  const Result<WallTime> time = wall_time_from_iso(recorded_at);
  if (time)
    facts.recorded_at = *time;
  else
    fields.complain("recorded_at", "a date like 2026-11-22T05:37:10+01:00");
  fields.read("person", facts.person);
  fields.read("coach", facts.coach);
  fields.read("view", facts.view);
  if (const auto hand = fields.choice("hand", {"right", "left"}))
    facts.hand = *hand == 0 ? Handedness::Right : Handedness::Left;
  fields.read("stroke", facts.stroke);
  fields.read("notes", facts.notes);
  fields.read("star", facts.star);
  fields.read("seconds", facts.seconds);
  fields.read("frames", facts.frames);
  fields.read("score_percent", facts.score_percent);
  fields.read("score_plus_minus", facts.score_plus_minus);
  fields.read("advice", facts.advice);
  fields.read("camera", facts.camera);
  fields.read("source", facts.source);
}

// A text where there is one; a key that was there and says nothing any more goes.
void put(PlainJson& json, const char* key, const std::string& text) {
  if (text.empty())
    json.erase(key);
  else
    json[key] = text;
}

void put(PlainJson& json, const SwingFacts& facts) {
  json["recorded_at"] = to_iso(facts.recorded_at);
  put(json, "person", facts.person);
  put(json, "coach", facts.coach);
  put(json, "view", facts.view);
  put(json, "hand", !facts.hand ? "" : *facts.hand == Handedness::Left ? "left" : "right");
  put(json, "stroke", facts.stroke);
  json["notes"] = facts.notes;
  json["star"] = facts.star;
  json["seconds"] = facts.seconds;
  json["frames"] = facts.frames;
  if (facts.score_percent) {
    json["score_percent"] = *facts.score_percent;
    json["score_plus_minus"] = facts.score_plus_minus;
  } else {
    json.erase("score_percent");
    json.erase("score_plus_minus");
  }
  put(json, "advice", facts.advice);
  put(json, "camera", facts.camera);
  put(json, "source", facts.source);
  PlainJson& counters = json["counters"];
  if (!counters.is_object()) counters = PlainJson::object();
  counters["captured"] = facts.counters.captured;
  counters["lost_by_camera"] = facts.counters.lost_by_camera;
  counters["lost_by_recorder"] = facts.counters.lost_by_recorder;
  counters["skipped_by_pose"] = facts.counters.skipped_by_pose;
}

}  // namespace

std::optional<fs::path> Swing::file(std::string_view kind) const {
  for (const auto& [name, ignored] : files) {
    const std::string start(kind);
    // "student" is student.pose.json or student.bvh; student.body.json is "student.body".
    const bool is_body = name.starts_with("student.body.");
    if (name.starts_with(start + ".") && (!is_body || kind != "student")) return folder / name;
  }
  return {};
}

Result<Swing> swing_from_json(const fs::path& folder, std::string_view text) {
  const std::string file = (folder / kSwingFile).string();
  const Result<PlainJson> json = parse_plain_json(file, text);
  if (!json) return tl::unexpected(json.error());
  if (const Result<int> version = schema_version(*json, kSwingSchema, kNewest, file); !version)
    return tl::unexpected(version.error());
  Swing swing;
  swing.folder = folder;
  swing.id = (folder.parent_path().filename() / folder.filename()).string();
  PlainFields fields(*json, file);
  read_facts(fields, swing.facts);
  const PlainJson counters_json = fields.object("counters"), files_json = fields.object("files");
  PlainFields counters(counters_json, file);
  read_counters(counters, swing.facts.counters);
  for (const auto& [name, stored] : files_json.items()) {
    PlainFields file_fields(stored, file);
    StoredFile& entry = swing.files[name];
    file_fields.read("bytes", entry.bytes);
    file_fields.read("sha256", entry.sha256);
    // A name that leads elsewhere would let a foreign swing name any file of this machine.
    if (!stored.is_object() || fs::path(name).filename() != name || name == "..")
      fields.complain("files", "plain file names, each with \"bytes\" and \"sha256\"");
    if (const Result<void> checked = file_fields.checked(); !checked) return tl::unexpected(checked.error());
  }
  for (const PlainFields* part : {&fields, &counters})
    if (const Result<void> checked = part->checked(); !checked) return tl::unexpected(checked.error());
  return swing;
}

Result<Swing> read_swing(const fs::path& folder) {
  const Result<std::string> text = read_file(folder / kSwingFile, kLargestSwingFile);
  if (!text) return tl::unexpected(text.error());
  return swing_from_json(folder, *text);
}

std::string swing_to_json(const Swing& swing, std::string_view old_text) {
  PlainJson json = PlainJson::object();
  if (!old_text.empty())
    if (Result<PlainJson> old = parse_plain_json(kSwingFile, old_text)) json = *std::move(old);
  json["schema"] = "posecoach." + std::string(kSwingSchema) + "/" + std::to_string(kNewest);
  put(json, swing.facts);
  PlainJson files = PlainJson::object();
  for (const auto& [name, stored] : swing.files)
    files[name] = {{"bytes", stored.bytes}, {"sha256", stored.sha256}};
  json["files"] = files;
  return to_text(json);
}

}  // namespace posecoach
