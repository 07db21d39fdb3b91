#include "core/session/settings.h"

#include "core/base/json_text.h"
#include "core/session/plain_json.h"

namespace posecoach {
namespace {

constexpr const char* kSettingsSchema = "posecoach.settings/1";
constexpr double kSlowest = 0.125, kFastest = 2, kLargestScale = 4;

std::string number_words(double number) {
  std::string words;
  append_json_number(words, number, 3);
  return words;
}

// Within its limits, or the default.
void read_between(PlainFields& fields, const char* key, double smallest, double largest, double& out) {
  double value = out;
  fields.read(key, value);
  if (value >= smallest && value <= largest)
    out = value;
  else
    fields.complain(key, number_words(smallest) + " to " + number_words(largest));
}

// A value of the wrong kind or out of range is its default and told.
LoadedSettings settings_from(const PlainJson& json, const std::string& file) {
  Settings settings;
  PlainFields fields(json, file);
  const PlainJson camera_json = fields.object("camera"), keys_json = fields.object("keys");
  PlainFields camera(camera_json, file), keys(keys_json, file);
  camera.read("stable_path", settings.camera.stable_path);
  camera.read("pixel_format", settings.camera.pixel_format);
  camera.read("width", settings.camera.width);
  camera.read("height", settings.camera.height);
  camera.read("fps", settings.camera.fps);
  if (const auto theme = fields.choice("theme", {"dark", "light"}))
    settings.theme = *theme == 0 ? "dark" : "light";
  if (const auto palette = fields.choice("palette", {"red-green", "colour-blind"}))
    settings.palette = *palette == 0 ? "red-green" : "colour-blind";
  read_between(fields, "interface_scale", 0, kLargestScale, settings.interface_scale);
  read_between(fields, "speed", kSlowest, kFastest, settings.speed);
  read_between(fields, "volume", 0, 1, settings.volume);
  fields.read("person", settings.person);
  for (const auto& [action, key] : keys_json.items()) {
    std::string name;
    keys.read(action.c_str(), name);
    if (!name.empty()) settings.keys[action] = name;
  }
  LoadedSettings loaded{settings, {}};
  for (const PlainFields* part : {&fields, &camera, &keys})
    if (const Result<void> checked = part->checked(); !checked && loaded.message.empty())
      loaded.message = checked.error().message + "; its default counts";
  return loaded;
}

void put(PlainJson& json, const Settings& settings) {
  if (!json.contains("schema")) json["schema"] = kSettingsSchema;
  PlainJson& camera = json["camera"];
  if (!camera.is_object()) camera = PlainJson::object();
  camera["stable_path"] = settings.camera.stable_path;
  camera["pixel_format"] = settings.camera.pixel_format;
  camera["width"] = settings.camera.width;
  camera["height"] = settings.camera.height;
  camera["fps"] = settings.camera.fps;
  json["theme"] = settings.theme;
  json["palette"] = settings.palette;
  json["interface_scale"] = settings.interface_scale;
  json["speed"] = settings.speed;
  json["volume"] = settings.volume;
  json["person"] = settings.person;
  json["keys"] = settings.keys;
}

}  // namespace

LoadedSettings SettingsFile::load() {
  const Result<PlainJson> json = read_plain_json(path_);
  if (!json && json.error().code == ErrorCode::NotFound) return {};
  if (json) return settings_from(*json, path_.string());
  if (json.error().code == ErrorCode::Unreadable)
    return {{}, json.error().message + "; the defaults count for now"};
  const std::string aside = path_.string() + ".broken";
  if (disk_.rename(path_.c_str(), aside.c_str()) != 0)
    return {{}, json.error().message + "; the defaults count for now"};
  return {{}, json.error().message + "; set aside as " + aside + ", the defaults count now"};
}

Result<void> SettingsFile::save(const Settings& settings) {
  Result<PlainJson> json = read_plain_json(path_);
  if (!json) {
    if (json.error().code == ErrorCode::Unreadable) return tl::unexpected(json.error());
    if (const Result<void> made = make_folders(disk_, path_.parent_path()); !made) return made;
    json = PlainJson::object();
  }
  put(*json, settings);
  return store_file(disk_, path_, to_text(*json));
}

}  // namespace posecoach
