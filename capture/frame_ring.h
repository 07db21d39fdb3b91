// The last seconds in memory, so that a swing is kept from before anybody knew that it began.
#pragma once

#include <cstddef>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "capture/v4l2/jpeg.h"
#include "core/base/error.h"
#include "core/image/frame.h"

namespace posecoach {

// A frame as a JPEG; copies share the bytes.
struct CompressedFrame {
  std::size_t index = 0;
  MediaTime time;
  std::optional<CaptureTime> captured_at;
  int width = 0;
  int height = 0;
  std::shared_ptr<const Bytes> jpeg;  // never null
};

// Error: Malformed, which a frame of our own never is.
Result<Image> decompressed(const CompressedFrame& frame);

struct FrameRingOptions {
  std::size_t most_bytes = std::size_t{256} << 20;
  Duration longest = std::chrono::seconds(20);
  int quality = 90;  // of the JPEGs
};

// Safe from several threads; push() compresses on the thread that calls (3 to 5 ms for 1280x720).
class FrameRing {
 public:
  explicit FrameRing(const FrameRingOptions& options = {});

  // Forgets the oldest frames so that both bounds hold. A frame whose time goes back starts the ring anew.
  void push(const Frame& frame);
  // Both ends belong to it; frames in their order.
  std::vector<CompressedFrame> frames_between(MediaTime first, MediaTime last) const;
  void clear();

  struct Held {
    std::size_t frames = 0;
    std::size_t bytes = 0;
    Duration length{};
  };
  Held held() const;

 private:
  FrameRingOptions options_;
  std::mutex encoding_;
  JpegEncoder encoder_;
  mutable std::mutex mutex_;
  std::deque<CompressedFrame> frames_;
  std::size_t bytes_ = 0;
};

enum class ClipCodec {
  H264,  // a tenth of the size; decodes and encodes each frame: 5 to 10 ms for 1280x720
  Jpeg   // the frames as they are: as fast as the disk
};

// A Matroska film (.mkv) of the frames with their own times, the first at 0. It appears under its name when
// it is whole. Errors: Incomplete (no frames), InvalidArgument (times do not increase, not .mkv), NotFound or
// Unreadable (folder, permission, disk full).
Result<void> write_clip(std::span<const CompressedFrame> frames, const std::filesystem::path& path,
                        ClipCodec codec = ClipCodec::H264);

}  // namespace posecoach
