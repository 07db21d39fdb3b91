#include "core/session/places.h"

#include <pwd.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

#include "core/base/file.h"

namespace posecoach {
namespace fs = std::filesystem;
namespace {

constexpr const char* kFolder = "virtual-pose-coach";
constexpr std::size_t kUserDirsBytes = std::size_t{1} << 16;

std::optional<fs::path> absolute(const Environment& environment, const char* name) {
  const std::optional<std::string> value = environment(name);
  if (!value || !fs::path(*value).is_absolute()) return {};
  return fs::path(*value);
}

fs::path home(const Environment& environment) {
  if (const auto set = absolute(environment, "HOME")) return *set;
  const passwd* user = ::getpwuid(::getuid());
  return user != nullptr && user->pw_dir != nullptr ? fs::path(user->pw_dir) : fs::path("/");
}

// The value of XDG_VIDEOS_DIR="$HOME/Videos": absolute, or below the home; anything else does not count.
std::optional<fs::path> videos_line(std::string_view line, const fs::path& home) {
  constexpr std::string_view kStart = "XDG_VIDEOS_DIR=\"", kHome = "$HOME";
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  if (!line.starts_with(kStart)) return {};
  line.remove_prefix(kStart.size());
  std::string value;
  for (std::size_t i = 0; i < line.size() && line[i] != '"'; ++i) {
    if (line[i] == '\\' && i + 1 < line.size()) ++i;
    value += line[i];
  }
  if (value.starts_with("/")) return fs::path(value);
  if (!value.starts_with(kHome)) return {};
  const std::string below = value.substr(kHome.size());
  // A folder that is the home itself means, by the specification, that there is none for videos.
  if (below.empty() || below == "/") return home;
  return below.front() == '/' ? std::optional(home / below.substr(1)) : std::nullopt;
}

fs::path videos(const fs::path& config_home, const fs::path& home) {
  const Result<std::string> text = read_file(config_home / "user-dirs.dirs", kUserDirsBytes);
  std::optional<fs::path> found;
  for (std::size_t start = 0; text && start < text->size();) {
    const std::size_t end = std::min(text->find('\n', start), text->size());
    if (const auto line = videos_line(std::string_view(*text).substr(start, end - start), home)) found = line;
    start = end + 1;
  }
  return found.value_or(home / "Videos");
}

}  // namespace

Places find_places(const Environment& environment) {
  const fs::path user = home(environment);
  const fs::path config_home = absolute(environment, "XDG_CONFIG_HOME").value_or(user / ".config");
  Places places;
  places.config = config_home / kFolder;
  places.data = absolute(environment, "XDG_DATA_HOME").value_or(user / ".local/share") / kFolder;
  places.state = absolute(environment, "XDG_STATE_HOME").value_or(user / ".local/state") / kFolder;
  places.library =
      absolute(environment, "POSECOACH_LIBRARY").value_or(videos(config_home, user) / "VirtualPoseCoach");
  return places;
}

Places find_places() {
  return find_places([](const char* name) -> std::optional<std::string> {
    const char* value = std::getenv(name);
    if (value == nullptr) return {};
    return value;
  });
}

}  // namespace posecoach
