#include "capture/v4l2/camera_list.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <system_error>

#include "capture/v4l2/device.h"
#include "capture/v4l2/system_calls.h"

namespace posecoach {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kNodePrefix = "video";

std::optional<int> number_of(const fs::path& node) {
  const std::string name = node.filename().string();
  if (!name.starts_with(kNodePrefix)) return std::nullopt;
  int number = 0;
  const char* const end = name.data() + name.size();
  const auto [rest, failed] = std::from_chars(name.data() + kNodePrefix.size(), end, number);
  return failed == std::errc{} && rest == end ? std::optional(number) : std::nullopt;
}

std::vector<fs::path> video_nodes(const fs::path& folder) {
  std::vector<fs::path> nodes;
  std::error_code failed;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failed))
    if (number_of(entry.path())) nodes.push_back(entry.path());
  std::sort(nodes.begin(), nodes.end(),
            [](const fs::path& a, const fs::path& b) { return number_of(a) < number_of(b); });
  return nodes;
}

}  // namespace

fs::path stable_camera_path(const fs::path& node, const fs::path& device_folder) {
  std::error_code failed;
  const fs::path target = fs::weakly_canonical(node, failed);
  for (const char* kind : {"by-id", "by-path"}) {
    std::vector<fs::path> links;
    for (const fs::directory_entry& entry : fs::directory_iterator(device_folder / "v4l" / kind, failed)) {
      std::error_code broken;
      if (fs::weakly_canonical(entry.path(), broken) == target && !broken) links.push_back(entry.path());
    }
    if (!links.empty()) return *std::min_element(links.begin(), links.end());
  }
  return node;
}

std::vector<fs::path> camera_files(const CameraListOptions& options) {
  std::vector<fs::path> files = video_nodes(options.device_folder);
  const auto nodes = static_cast<std::ptrdiff_t>(files.size());
  std::error_code failed;
  for (const fs::directory_entry& link :
       fs::directory_iterator(options.device_folder / "v4l" / "by-id", failed))
    files.push_back(link.path());
  std::sort(files.begin() + nodes, files.end());
  return files;
}

std::vector<CameraDescription> list_cameras(const CameraListOptions& options) {
  V4l2SystemCalls& calls = options.system_calls == nullptr ? real_v4l2_system_calls() : *options.system_calls;
  std::vector<CameraDescription> cameras;
  for (const fs::path& node : video_nodes(options.device_folder)) {
    CameraDescription camera;
    camera.node = node;
    camera.path = stable_camera_path(node, options.device_folder);
    const Result<V4l2Device> device = V4l2Device::open(node, calls);
    if (device) {
      camera.name = device->name();
      camera.driver = device->driver();
      camera.bus = device->bus();
      camera.modes = device->modes();
      if (camera.modes.empty()) camera.problem = "it has no picture format that can be decoded";
    } else {
      // Metadata nodes, outputs and tuners stand in the same folder.
      if (device.error().code == ErrorCode::Unsupported) continue;
      camera.problem = device.error().message;
    }
    cameras.push_back(std::move(camera));
  }
  return cameras;
}

}  // namespace posecoach
