// A camera's stream of memory-mapped buffers: the driver fills them in turn, and each is copied out and given
// back at once, so that the driver never waits for us.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "capture/v4l2/device.h"
#include "core/base/time.h"

namespace posecoach {

struct FilledBuffer {
  std::span<const std::uint8_t> bytes;  // valid until the next call
  std::uint32_t sequence = 0;           // the driver's count; a gap is a lost frame
  CaptureTime captured_at;              // the driver's stamp, else now
  bool is_damaged = false;              // as the driver says
};

class BufferStream {
 public:
  // `device` outlives the stream. Errors: Unreadable (busy, no memory), Unsupported, DeviceLost.
  static Result<std::unique_ptr<BufferStream>> start(const V4l2Device& device);
  ~BufferStream();
  BufferStream(const BufferStream&) = delete;
  BufferStream& operator=(const BufferStream&) = delete;

  // Waits at most `longest`; nothing when no buffer was filled. A stream that fails is started again, up to
  // three times in a row. Errors: DeviceLost (unplugged, changed its format), Unreadable.
  Result<std::optional<FilledBuffer>> next(Duration longest);

 private:
  struct Mapping {
    void* address = nullptr;
    std::size_t length = 0;
  };

  explicit BufferStream(const V4l2Device& device) : device_(device) {}
  Result<void> map_buffers();
  Result<void> run();
  Result<void> queue(std::uint32_t index);
  Result<std::optional<FilledBuffer>> dequeue(bool has_error);
  Result<std::optional<FilledBuffer>> restart_after(int reason);
  Result<void> take_events();

  const V4l2Device& device_;
  std::vector<Mapping> mappings_;
  std::vector<std::uint8_t> copy_;
  int failures_ = 0;  // since the last good buffer
};

}  // namespace posecoach
