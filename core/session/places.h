// Where everything is kept: the XDG base directories (version 0.8), and the sessions in a folder that users
// see. Nothing is created by asking.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace posecoach {

struct Places {
  std::filesystem::path config;   // settings.json
  std::filesystem::path data;     // people, references, pose models
  std::filesystem::path state;    // the window's layout, logs
  std::filesystem::path library;  // the recorded swings

  std::filesystem::path settings_file() const { return config / "settings.json"; }
  std::filesystem::path people() const { return data / "people"; }
  std::filesystem::path references() const { return data / "references"; }
};

using Environment = std::function<std::optional<std::string>(const char* name)>;

// $XDG_CONFIG_HOME, $XDG_DATA_HOME, $XDG_STATE_HOME (each /virtual-pose-coach), else ~/.config,
// ~/.local/share,
// ~/.local/state; relative values count as not set. The library is $POSECOACH_LIBRARY where it is absolute,
// else VirtualPoseCoach in the user's folder of videos (user-dirs.dirs, else ~/Videos).
Places find_places(const Environment& environment);
// In this process' environment.
Places find_places();

}  // namespace posecoach
