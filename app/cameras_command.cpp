#include "app/cameras_command.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "capture/v4l2/camera_list.h"
#include "core/base/file.h"

namespace posecoach {
namespace {

std::string rate_text(double rate) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", std::round(100 * rate) / 100);
  return text;
}

std::string rates_text(const CameraMode& mode) {
  std::string text;
  for (const double rate : mode.frame_rates) text += (text.empty() ? "" : ", ") + rate_text(rate);
  return text.empty() ? "?" : text;
}

void print(const std::vector<CameraDescription>& cameras) {
  if (cameras.empty()) {
    std::printf(
        "No camera is connected. Plug one in and ask again; without one, try --source simulated:swing,\n"
        "or analyse a film: posecoach analyze --coach bundled:swing --student my-swing.mp4\n");
    return;
  }
  for (const CameraDescription& camera : cameras) {
    std::printf("%s\n  %s", camera.name.empty() ? "Camera" : camera.name.c_str(), camera.source().c_str());
    if (camera.path != camera.node) std::printf("  (now %s)", camera.node.c_str());
    std::printf("\n");
    if (!camera.problem.empty()) {
      std::printf("  cannot be used: %s\n", camera.problem.c_str());
      continue;
    }
    const auto ours = choose_mode(camera.modes, {});
    for (const CameraMode& mode : camera.modes) {
      const bool is_ours = ours && ours->pixel_format == mode.pixel_format && ours->width == mode.width &&
                           ours->height == mode.height;
      std::printf("  %c %4d x %-4d  %-5s %s frames a second\n", is_ours ? '*' : ' ', mode.width, mode.height,
                  pixel_format_name(mode.pixel_format).c_str(), rates_text(mode).c_str());
    }
  }
  std::printf(
      "\n* is taken unless you ask for another: camera:PATH?width=1280&height=720&fps=30&format=MJPG\n");
}

std::string json_of(const std::vector<CameraDescription>& cameras) {
  nlohmann::json list = nlohmann::json::array();
  for (const CameraDescription& camera : cameras) {
    nlohmann::json modes = nlohmann::json::array();
    for (const CameraMode& mode : camera.modes)
      modes.push_back({{"format", pixel_format_name(mode.pixel_format)},
                       {"width", mode.width},
                       {"height", mode.height},
                       {"fps", mode.frame_rates}});
    list.push_back({{"source", camera.source()},
                    {"path", camera.path.string()},
                    {"node", camera.node.string()},
                    {"name", camera.name},
                    {"driver", camera.driver},
                    {"bus", camera.bus},
                    {"modes", modes},
                    {"problem", camera.problem}});
  }
  // A device may call itself anything.
  return nlohmann::json{{"schema", "posecoach.cameras/1"}, {"cameras", list}}.dump(
             1, ' ', false, nlohmann::json::error_handler_t::replace) +
         "\n";
}

Result<void> run(const std::string& json) {
  const std::vector<CameraDescription> cameras = list_cameras();
  if (json != "-") print(cameras);
  return json.empty() ? Result<void>() : write_file_atomically(json, json_of(cameras));
}

}  // namespace

void add_cameras_command(CLI::App& cli, Action& action) {
  auto json = std::make_shared<std::string>();
  CLI::App* command = cli.add_subcommand("cameras", "The cameras of this machine, with their modes");
  command->add_option("--json", *json, "Write the list as JSON; - for standard output")->type_name("FILE");
  command->callback([&action, json] { action = [json] { return run(*json); }; });
}

}  // namespace posecoach
