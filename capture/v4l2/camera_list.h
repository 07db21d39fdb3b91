// The cameras of this machine, with what each can do.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "capture/v4l2/camera_mode.h"

namespace posecoach {

class V4l2SystemCalls;

struct CameraDescription {
  // Names the same camera after re-plugging and restarting: /dev/v4l/by-id/..., else by-path, else
  // /dev/videoN.
  std::filesystem::path path;
  std::filesystem::path node;  // /dev/videoN, as it is now
  std::string name;            // as the device calls itself
  std::string driver;
  std::string bus;
  std::vector<CameraMode> modes;  // that we can decode; largest first, then fastest
  std::string problem;            // why it cannot be used, and what to do; empty when it can

  // For open_source().
  std::string source() const { return "camera:" + path.string(); }
};

struct CameraListOptions {
  std::filesystem::path device_folder = "/dev";
  V4l2SystemCalls* system_calls = nullptr;  // the real ones
};

// The files of what may be cameras, and the links to them: whether they changed tells whether anything was
// plugged in or out, without asking any device.
std::vector<std::filesystem::path> camera_files(const CameraListOptions& options = {});

// In the order of their numbers. Devices that are no cameras (outputs, metadata, tuners) are left out;
// cameras that cannot be opened are listed with their problem. A few milliseconds a camera; safe from any
// thread, also while a camera streams.
std::vector<CameraDescription> list_cameras(const CameraListOptions& options = {});

// /dev/video0 as the stable path of the same device, where the system keeps one.
std::filesystem::path stable_camera_path(const std::filesystem::path& node,
                                         const std::filesystem::path& device_folder = "/dev");

}  // namespace posecoach
