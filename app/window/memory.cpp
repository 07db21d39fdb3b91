#include "app/window/memory.h"

#include "core/base/log.h"
#include "core/session/settings.h"

namespace posecoach {
namespace {

constexpr std::string_view kCamera = "camera:";

}  // namespace

class Memory::File {
 public:
  explicit File(const std::filesystem::path& path) : file(path), loaded(file.load()) {}
  SettingsFile file;
  LoadedSettings loaded;
};

Memory::Memory(const std::filesystem::path& file) : file_(std::make_unique<File>(file)) {
  const Settings& settings = file_->loaded.settings;
  if (!settings.camera.stable_path.empty())
    remembered.source = std::string(kCamera) + settings.camera.stable_path;
  remembered.width = settings.camera.width;
  remembered.height = settings.camera.height;
  remembered.fps = settings.camera.fps;
  remembered.format = settings.camera.pixel_format;
  remembered.theme = settings.theme;
  remembered.palette = settings.palette;
  remembered.text_size = settings.interface_scale > 0 ? settings.interface_scale : 1;
  remembered.is_sound_on = settings.volume > 0;
  remembered.person = settings.person;
  remembered.keys = settings.keys;
}

Memory::~Memory() = default;

const std::string& Memory::message() const {
  return file_->loaded.message;
}

void Memory::save() {
  Settings& settings = file_->loaded.settings;
  if (remembered.source.starts_with(kCamera)) {
    settings.camera.stable_path = remembered.source.substr(kCamera.size());
    settings.camera.width = remembered.width;
    settings.camera.height = remembered.height;
    settings.camera.fps = remembered.fps;
    settings.camera.pixel_format = remembered.format;
  }
  settings.theme = remembered.theme;
  settings.palette = remembered.palette;
  settings.interface_scale = remembered.text_size;
  settings.volume = remembered.is_sound_on ? (settings.volume > 0 ? settings.volume : 0.8) : 0;
  settings.person = remembered.person;
  settings.keys = remembered.keys;
  if (const Result<void> saved = file_->file.save(settings); !saved) log::warning(saved.error().message);
}

}  // namespace posecoach
