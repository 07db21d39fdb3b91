// What the program remembers between runs, in settings.json: the camera, the looks, the keys, who practised
// last.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/base/error.h"
#include "core/session/disk.h"

namespace posecoach {

struct CameraChoice {
  std::string stable_path;   // /dev/v4l/by-id/...; empty: none was chosen
  std::string pixel_format;  // "MJPG", "YUYV"; empty: the best
  int width = 0, height = 0;
  double fps = 0;
};

struct Settings {
  CameraChoice camera;
  std::string theme = "dark";               // "dark", "light"
  std::string palette = "red-green";        // or "colour-blind"
  double interface_scale = 0;               // 0: as the display says
  double speed = 1;                         // of replays, 1/8 to 2
  double volume = 0.8;                      // 0 to 1
  std::string person;                       // who practised last; empty: the default person
  std::map<std::string, std::string> keys;  // action to key; those not named keep their default
};

struct LoadedSettings {
  Settings settings;
  // What was wrong with the file, where it was set aside to, for people; empty where all was well.
  std::string message;
};

class SettingsFile {
 public:
  explicit SettingsFile(std::filesystem::path path, Disk& disk = system_disk())
      : path_(std::move(path)), disk_(disk) {}

  // Never fails: without a file the defaults; a value that cannot be is its default; a file that is no
  // JSON at all is renamed to settings.json.broken and the defaults count.
  LoadedSettings load();
  // Atomic; keys that this version does not know stay in the file. Errors: Unreadable.
  Result<void> save(const Settings& settings);

 private:
  std::filesystem::path path_;
  Disk& disk_;
};

}  // namespace posecoach
