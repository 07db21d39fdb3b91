// An open camera before it streams: what it is, what it can do, what it agrees to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "capture/v4l2/camera_mode.h"
#include "core/base/error.h"

namespace posecoach {

class V4l2SystemCalls;

// The driver's answer to a request; never what was requested.
struct AgreedFormat {
  std::uint32_t pixel_format = 0;
  int width = 0;
  int height = 0;
  std::size_t bytes_a_row = 0;  // of raw pictures; may exceed what the pixels take
  std::size_t bytes_a_picture = 0;
  bool has_full_range = false;      // of raw YUV; else 16 to 235
  bool has_rec709_colours = false;  // of raw YUV; else Rec. 601
  double fps = 0;                   // 0 when the driver does not tell
};

class V4l2Device {
 public:
  // Errors: NotFound, Unreadable (permission: says which group to join; another program holds it),
  // Unsupported (no camera, or one without streaming), DeviceLost.
  static Result<V4l2Device> open(const std::filesystem::path& path, V4l2SystemCalls& calls);
  V4l2Device(V4l2Device&& other) noexcept;
  V4l2Device& operator=(V4l2Device&& other) = delete;
  ~V4l2Device();

  const std::string& name() const { return name_; }
  const std::string& driver() const { return driver_; }
  const std::string& bus() const { return bus_; }

  // Those that we can decode, largest first.
  std::vector<CameraMode> modes() const;
  // Sets format, size and rate. Errors: Unsupported, Unreadable (busy), DeviceLost.
  Result<AgreedFormat> agree(const ChosenMode& mode);
  // The format that is set now.
  Result<AgreedFormat> agreed() const;

  // With EINTR tried again; 0 or an errno.
  int control(unsigned long request, void* argument) const;
  // What an errno of this device means, in one line with its name and what to do.
  Error error(std::string_view what, int reason) const;

  int descriptor() const { return descriptor_; }
  V4l2SystemCalls& calls() const { return *calls_; }
  const std::filesystem::path& path() const { return path_; }

 private:
  V4l2Device(std::filesystem::path path, int descriptor, V4l2SystemCalls& calls);
  Result<void> identify();
  std::vector<double> frame_rates(std::uint32_t format, int width, int height) const;
  void add_sizes(std::uint32_t format, std::vector<CameraMode>& modes) const;
  double set_rate(double fps) const;

  std::filesystem::path path_;
  int descriptor_ = -1;
  V4l2SystemCalls* calls_ = nullptr;
  std::string name_, driver_, bus_;
};

}  // namespace posecoach
