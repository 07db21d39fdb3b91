#include "app/library/library_text.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "core/coaching/text/metric_text.h"

namespace posecoach {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLongestNotes = 40;

std::size_t characters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

// The first `most` characters, on one line.
std::string shortened(const std::string& text, std::size_t most) {
  std::string out;
  std::size_t seen = 0;
  for (const char c : one_line(text)) {
    const bool starts = (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    if (starts && ++seen > most) return out + "…";
    out += c;
  }
  return out;
}

std::string rounded(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  const auto whole = std::llround(value * scale);
  std::string digits = std::to_string(std::abs(whole));
  const auto places = static_cast<std::size_t>(decimals);
  if (decimals > 0) {
    if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
    digits.insert(digits.size() - places, ".");
  }
  return (whole < 0 ? "-" : "") + digits;
}

std::string score_of(const SwingFacts& facts) {
  return facts.score_percent ? rounded(*facts.score_percent, 0) + " %" : "—";
}

std::string hand_of(const SwingFacts& facts) {
  return !facts.hand ? "" : *facts.hand == Handedness::Left ? "left" : "right";
}

}  // namespace

std::string table_of(const std::vector<Swing>& swings) {
  std::vector<std::vector<std::string>> rows = {
      {"SWING", "", "RECORDED", "PERSON", "SCORE", "COACH", "NOTES"}};
  for (const Swing& swing : swings) {
    if (!swing.is_readable()) continue;
    const SwingFacts& facts = swing.facts;
    rows.push_back({one_line(swing.id), facts.star ? "★" : "", to_words(facts.recorded_at),
                    shortened(facts.person, 20), score_of(facts), shortened(facts.coach, 28),
                    shortened(facts.notes, kLongestNotes)});
  }
  std::vector<std::size_t> widths(rows.front().size());
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], characters(row[i]));
  std::string out;
  for (std::size_t r = rows.size() > 1 ? 0 : 1; r < rows.size(); ++r) {
    std::string line;
    for (std::size_t i = 0; i < rows[r].size(); ++i)
      line += rows[r][i] + std::string(widths[i] - characters(rows[r][i]) + 2, ' ');
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + "\n";
  }
  for (const Swing& swing : swings)
    if (!swing.is_readable())
      out += one_line(swing.id) + "  unreadable: " + one_line(swing.unreadable) + "\n";
  return out;
}

std::string page_of(const Swing& swing) {
  const SwingFacts& facts = swing.facts;
  std::vector<std::pair<std::string, std::string>> rows = {
      {"Swing",
       swing.id + (facts.star ? "  ★" : "") + (swing.shelf == Shelf::Trash ? "  (in the trash)" : "")},
      {"Folder", swing.folder.string()},
      {"Recorded", to_words(facts.recorded_at)},
      {"Person", facts.person},
      {"Hand", hand_of(facts)},
      {"View", facts.view},
      {"Stroke", facts.stroke},
      {"Length",
       facts.frames > 0 ? rounded(facts.seconds, 2) + " s, " + std::to_string(facts.frames) + " frames" : ""},
      {"Coach", facts.coach},
      {"Score", facts.score_percent
                    ? rounded(*facts.score_percent, 1) + " % ± " + rounded(facts.score_plus_minus, 1)
                    : ""},
      {"Advice", facts.advice},
      {"Camera", facts.camera},
      {"From", facts.source},
      {"Notes", facts.notes}};
  std::string out;
  for (const auto& [name, value] : rows)
    if (!value.empty()) out += name + std::string(10 - name.size(), ' ') + one_line(value) + "\n";
  const RecordingCounters& counters = facts.counters;
  if (counters.captured > 0)
    out += "Frames    " + std::to_string(counters.captured) + " captured, " +
           std::to_string(counters.lost_by_camera) + " lost by the camera, " +
           std::to_string(counters.lost_by_recorder) + " by the recorder; the pose stage skipped " +
           std::to_string(counters.skipped_by_pose) + "\n";
  for (const auto& [name, stored] : swing.files)
    out += "File      " + one_line(name) + ", " + std::to_string(stored.bytes) + " bytes\n";
  return out;
}

std::string page_of(const Block& block) {
  std::size_t width = 0;
  for (const MetricSpread& metric : block.metrics) width = std::max(width, characters(metric.title));
  std::string page = block.words + "\n\n";
  for (const MetricSpread& metric : block.metrics) {
    if (metric.spread.count < 2) continue;
    const int decimals = metric.spread.deviation >= 3 ? 0 : metric.spread.deviation >= 0.2 ? 1 : 2;
    page += metric.title + std::string(width + 2 - characters(metric.title), ' ') +
            rounded(metric.spread.mean, decimals) + " ± " + rounded(metric.spread.deviation, decimals) +
            text::unit(metric.unit) + "\n";
  }
  for (const RepeatedAdvice& advice : block.advice)
    page += "\n" + std::to_string(advice.swings) + " of " + std::to_string(block.swings) + ": " +
            one_line(advice.text);
  return page + (block.advice.empty() ? "" : "\n");
}

Json json_of(const Swing& swing) {
  Json json{{"id", swing.id},
            {"shelf", swing.shelf == Shelf::Trash ? "trash" : "kept"},
            {"folder", swing.folder.string()}};
  if (!swing.is_readable()) {
    json["unreadable"] = swing.unreadable;
    return json;
  }
  const SwingFacts& facts = swing.facts;
  json["recorded_at"] = to_iso(facts.recorded_at);
  json["person"] = facts.person;
  json["coach"] = facts.coach;
  json["view"] = facts.view;
  json["hand"] = facts.hand ? Json(hand_of(facts)) : Json(nullptr);
  json["stroke"] = facts.stroke;
  json["notes"] = facts.notes;
  json["star"] = facts.star;
  json["seconds"] = facts.seconds;
  json["frames"] = facts.frames;
  json["score_percent"] = facts.score_percent ? Json(*facts.score_percent) : Json(nullptr);
  json["score_plus_minus"] = facts.score_plus_minus;
  json["advice"] = facts.advice;
  json["camera"] = facts.camera;
  json["source"] = facts.source;
  json["counters"] = {{"captured", facts.counters.captured},
                      {"lost_by_camera", facts.counters.lost_by_camera},
                      {"lost_by_recorder", facts.counters.lost_by_recorder},
                      {"skipped_by_pose", facts.counters.skipped_by_pose}};
  json["files"] = Json::object();
  for (const auto& [name, stored] : swing.files)
    json["files"][name] = {{"bytes", stored.bytes}, {"sha256", stored.sha256}};
  return json;
}

Json json_of(const Library& library, const std::vector<Swing>& swings) {
  Json json{
      {"schema", "posecoach.library/1"}, {"folder", library.folder().string()}, {"swings", Json::array()}};
  for (const Swing& swing : swings) json["swings"].push_back(json_of(swing));
  return json;
}

Result<void> write_json(const std::string& file, const Json& json) {
  if (file.empty()) return {};
  return write_file_atomically(file, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace posecoach
