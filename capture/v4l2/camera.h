// A V4L2 camera as a source of frames.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>

#include "capture/v4l2/buffer_stream.h"
#include "capture/v4l2/picture_decoder.h"
#include "core/pipeline/frame_source.h"

namespace posecoach {

struct V4l2CameraOptions {
  std::filesystem::path path;  // of the device, or a link to it
  std::string name = {};       // as the user wrote it; the path when empty
  CameraWish wish = {};
  // Without any good picture for so long, next() fails: opening the camera again often helps.
  Duration longest_silence = std::chrono::seconds(3);
  V4l2SystemCalls* system_calls = nullptr;  // the real ones
};

struct CameraStatistics {
  std::uint64_t delivered = 0;
  std::uint64_t lost = 0;    // gaps in the driver's count
  std::uint64_t broken = 0;  // flagged by the driver, cut short or damaged: left out, and gaps as well
};

// Frames carry the driver's stamps; gaps in its count are gaps in Frame::index. Time counts from the first
// frame.
class V4l2Camera : public FrameSource {
 public:
  // Errors: NotFound, Unreadable (permission, busy), Unsupported, DeviceLost.
  static Result<std::unique_ptr<V4l2Camera>> open(const V4l2CameraOptions& options);

  const FrameSourceInfo& info() const override { return info_; }
  // Errors: DeviceLost (unplugged, changed the size of its pictures, silent), Unreadable, Cancelled within a
  // tenth of a second after the stop.
  Result<std::optional<Frame>> next(std::stop_token stop) override;

  // What the driver agreed to.
  const AgreedFormat& format() const { return format_; }
  // From any thread.
  CameraStatistics statistics() const;

 private:
  V4l2Camera(const V4l2CameraOptions& options, V4l2Device device, const AgreedFormat& format);
  void count(std::uint32_t sequence);
  // Nothing when the picture is to be left out.
  Result<std::optional<Image>> picture_of(const FilledBuffer& buffer);
  Result<bool> has_the_films_size(const Image& image);
  Frame frame_of(Image image, CaptureTime captured_at);

  V4l2CameraOptions options_;
  V4l2Device device_;
  AgreedFormat format_;
  FrameSourceInfo info_;
  PictureDecoder decoder_;
  std::unique_ptr<BufferStream> stream_;

  std::optional<std::uint32_t> last_sequence_;
  std::size_t index_ = 0;
  std::optional<CaptureTime> first_stamp_;
  CaptureTime last_stamp_;
  std::chrono::steady_clock::time_point last_good_;
  int odd_width_ = 0, odd_height_ = 0, odd_count_ = 0;
  std::atomic<std::uint64_t> delivered_ = 0, lost_ = 0, broken_ = 0;
};

}  // namespace posecoach
