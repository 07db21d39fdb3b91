#include "capture/v4l2/buffer_stream.h"

#include <linux/videodev2.h>
#include <sys/mman.h>

#include <algorithm>
#include <cerrno>
#include <thread>

#include "capture/v4l2/system_calls.h"

namespace posecoach {
namespace {

// One is being filled, one waits, one is being copied, one to spare.
constexpr std::uint32_t kBuffers = 4;
constexpr int kMostFailures = 3;
constexpr auto kAfterFailure = std::chrono::milliseconds(20);

v4l2_buffer empty_buffer(std::uint32_t index = 0) {
  v4l2_buffer buffer = {};
  buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  buffer.memory = V4L2_MEMORY_MMAP;
  buffer.index = index;
  return buffer;
}

// Stamps of another clock, or of a driver that gives none, are no better than the time of arrival.
CaptureTime stamp_of(const v4l2_buffer& buffer) {
  const CaptureTime now = std::chrono::steady_clock::now();
  if ((buffer.flags & V4L2_BUF_FLAG_TIMESTAMP_MASK) != V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC) return now;
  const CaptureTime stamp(std::chrono::seconds(buffer.timestamp.tv_sec) +
                          std::chrono::microseconds(buffer.timestamp.tv_usec));
  const bool is_plausible = stamp <= now + std::chrono::seconds(1) && stamp >= now - std::chrono::seconds(10);
  return is_plausible ? stamp : now;
}

}  // namespace

Result<std::unique_ptr<BufferStream>> BufferStream::start(const V4l2Device& device) {
  std::unique_ptr<BufferStream> stream(new BufferStream(device));
  v4l2_event_subscription changes = {};
  changes.type = V4L2_EVENT_SOURCE_CHANGE;
  device.control(VIDIOC_SUBSCRIBE_EVENT, &changes);  // webcams know no such event
  if (auto mapped = stream->map_buffers(); !mapped) return tl::unexpected(mapped.error());
  if (auto runs = stream->run(); !runs) return tl::unexpected(runs.error());
  return stream;
}

BufferStream::~BufferStream() {
  int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  device_.control(VIDIOC_STREAMOFF, &type);
  for (const Mapping& mapping : mappings_) device_.calls().munmap(mapping.address, mapping.length);
  v4l2_requestbuffers none = {};
  none.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  none.memory = V4L2_MEMORY_MMAP;
  device_.control(VIDIOC_REQBUFS, &none);
}

Result<void> BufferStream::map_buffers() {
  v4l2_requestbuffers request = {};
  request.count = kBuffers;
  request.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  request.memory = V4L2_MEMORY_MMAP;
  if (const int failed = device_.control(VIDIOC_REQBUFS, &request))
    return tl::unexpected(device_.error("gives no buffers", failed));
  if (request.count < 2) return tl::unexpected(device_.error("gives too few buffers", ENOMEM));
  for (std::uint32_t index = 0; index < request.count; ++index) {
    v4l2_buffer buffer = empty_buffer(index);
    if (const int failed = device_.control(VIDIOC_QUERYBUF, &buffer))
      return tl::unexpected(device_.error("gives no buffers", failed));
    void* address = device_.calls().mmap(buffer.length, PROT_READ, MAP_SHARED, device_.descriptor(),
                                         static_cast<off_t>(buffer.m.offset));
    if (address == MAP_FAILED) return tl::unexpected(device_.error("gives no buffers", errno));
    mappings_.push_back({address, buffer.length});
  }
  return {};
}

Result<void> BufferStream::run() {
  for (std::uint32_t index = 0; index < mappings_.size(); ++index)
    if (auto queued = queue(index); !queued) return queued;
  int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  if (const int failed = device_.control(VIDIOC_STREAMON, &type))
    return tl::unexpected(device_.error("does not start", failed));
  return {};
}

Result<void> BufferStream::queue(std::uint32_t index) {
  v4l2_buffer buffer = empty_buffer(index);
  if (const int failed = device_.control(VIDIOC_QBUF, &buffer))
    return tl::unexpected(device_.error("takes no buffer back", failed));
  return {};
}

Result<std::optional<FilledBuffer>> BufferStream::next(Duration longest) {
  pollfd wait = {device_.descriptor(), POLLIN | POLLPRI, 0};
  const auto timeout = std::chrono::ceil<std::chrono::milliseconds>(longest).count();
  const int ready = device_.calls().poll(&wait, 1, static_cast<int>(timeout));
  if (ready < 0 && errno != EINTR && errno != EAGAIN)
    return tl::unexpected(device_.error("cannot be waited for", errno));
  if (ready <= 0) return std::nullopt;
  if ((wait.revents & POLLNVAL) != 0) return tl::unexpected(device_.error("is gone", ENODEV));
  if ((wait.revents & POLLPRI) != 0)
    if (auto taken = take_events(); !taken) return tl::unexpected(taken.error());
  if ((wait.revents & (POLLIN | POLLERR | POLLHUP)) == 0) return std::nullopt;
  return dequeue((wait.revents & (POLLERR | POLLHUP)) != 0);
}

Result<std::optional<FilledBuffer>> BufferStream::dequeue(bool has_error) {
  v4l2_buffer buffer = empty_buffer();
  if (const int failed = device_.control(VIDIOC_DQBUF, &buffer)) {
    if (failed == EAGAIN && !has_error) return std::nullopt;
    if (failed == ENODEV || failed == ENXIO) return tl::unexpected(device_.error("is gone", failed));
    return restart_after(failed);
  }
  if (buffer.index >= mappings_.size())
    return tl::unexpected(device_.error("gives back a buffer that it never had", EPROTO));
  const Mapping& mapping = mappings_[buffer.index];
  const auto* bytes = static_cast<const std::uint8_t*>(mapping.address);
  copy_.assign(bytes, bytes + std::min<std::size_t>(buffer.bytesused, mapping.length));
  if (auto queued = queue(buffer.index); !queued) return tl::unexpected(queued.error());
  failures_ = 0;
  return FilledBuffer{copy_, buffer.sequence, stamp_of(buffer), (buffer.flags & V4L2_BUF_FLAG_ERROR) != 0};
}

Result<std::optional<FilledBuffer>> BufferStream::restart_after(int reason) {
  if (++failures_ > kMostFailures) return tl::unexpected(device_.error("fails again and again", reason));
  std::this_thread::sleep_for(kAfterFailure);
  int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  if (const int failed = device_.control(VIDIOC_STREAMOFF, &type))
    return tl::unexpected(device_.error("cannot be started again", failed));
  if (auto runs = run(); !runs) return tl::unexpected(runs.error());
  return std::nullopt;
}

Result<void> BufferStream::take_events() {
  bool has_changed = false;
  for (v4l2_event event = {}; device_.control(VIDIOC_DQEVENT, &event) == 0; event = {})
    has_changed |= event.type == V4L2_EVENT_SOURCE_CHANGE &&
                   (event.u.src_change.changes & V4L2_EVENT_SRC_CH_RESOLUTION) != 0;
  if (!has_changed) return {};
  return tl::unexpected(
      Error{ErrorCode::DeviceLost,
            "camera " + device_.path().string() + " changed the size of its pictures and is opened again"});
}

}  // namespace posecoach
