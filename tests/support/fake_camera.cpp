#include "tests/support/fake_camera.h"

#include <fcntl.h>
#include <linux/videodev2.h>
#include <sys/mman.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <thread>

namespace posecoach {
namespace {

using Kind = FakeCamera::Step::Kind;

template <typename Type>
Type& as(void* argument) {
  return *static_cast<Type*>(argument);
}

template <std::size_t size>
void put_text(unsigned char (&field)[size], const std::string& text) {
  std::memcpy(field, text.data(), std::min(size - 1, text.size()));
}

bool is_jpeg(std::uint32_t format) {
  return format == V4L2_PIX_FMT_MJPEG;
}

std::uint32_t bytes_a_pixel(std::uint32_t format) {
  switch (format) {
    case V4L2_PIX_FMT_RGB24:
    case V4L2_PIX_FMT_BGR24:
      return 3;
    case V4L2_PIX_FMT_GREY:
    case V4L2_PIX_FMT_NV12:
      return 1;
    default:
      return 2;
  }
}

int failed(int reason) {
  errno = reason;
  return -1;
}

}  // namespace

FakeCamera::FakeCamera(std::filesystem::path path, Habits habits)
    : path_(std::move(path)), habits_(std::move(habits)) {
  if (!habits_.modes.empty())
    agreed_ = {habits_.modes[0].pixel_format, habits_.modes[0].width, habits_.modes[0].height, 0};
}

FakeCamera::~FakeCamera() = default;

void FakeCamera::then(Step step) {
  const std::scoped_lock lock(mutex_);
  steps_.push_back(std::move(step));
}
void FakeCamera::then_forever(std::vector<std::uint8_t> bytes) {
  then_forever([bytes = std::move(bytes)](const ChosenMode&, std::uint32_t) { return bytes; },
               std::chrono::milliseconds(2));
}
void FakeCamera::then_forever(Scene scene, Duration interval) {
  const std::scoped_lock lock(mutex_);
  forever_ = std::move(scene);
  forever_interval_ = interval;
}
void FakeCamera::look_with(Sensor sensor) {
  const std::scoped_lock lock(mutex_);
  sensor_ = std::move(sensor);
}

// Everything that the sensor has seen since it was asked last.
void FakeCamera::expose() {
  if (!sensor_ || !is_streaming_) return;
  const Duration now = sensor_->clock();
  if (!sensor_began_) sensor_began_ = now;
  while (taken_ < sensor_->pictures.size() &&
         *sensor_began_ + static_cast<std::int64_t>(taken_) * sensor_->interval <= now) {
    const std::size_t number = taken_++;
    if (exposed_.size() < queued_.size())
      exposed_.push_back({Kind::Picture, std::move(sensor_->pictures[number]),
                          static_cast<std::uint32_t>(number),
                          std::chrono::steady_clock::now().time_since_epoch()});
    else
      ++lost_;
  }
}

void FakeCamera::unplug() {
  const std::scoped_lock lock(mutex_);
  is_gone_ = true;
  dead_descriptors_ = descriptors_;
}
void FakeCamera::plug_in_at(std::filesystem::path path) {
  const std::scoped_lock lock(mutex_);
  path_ = std::move(path);
  is_gone_ = is_failing_ = is_streaming_ = false;
  next_sequence_ = 0;
}

std::vector<std::string> FakeCamera::broken_rules() const {
  const std::scoped_lock lock(mutex_);
  return broken_rules_;
}
int FakeCamera::opened() const {
  const std::scoped_lock lock(mutex_);
  return opened_;
}
int FakeCamera::left_open() const {
  const std::scoped_lock lock(mutex_);
  return static_cast<int>(descriptors_.size());
}
int FakeCamera::left_mapped() const {
  const std::scoped_lock lock(mutex_);
  return static_cast<int>(mapped_.size());
}
int FakeCamera::started() const {
  const std::scoped_lock lock(mutex_);
  return started_;
}
std::size_t FakeCamera::steps_left() const {
  const std::scoped_lock lock(mutex_);
  return steps_.size();
}
std::size_t FakeCamera::pictures_lost() const {
  const std::scoped_lock lock(mutex_);
  return lost_;
}
ChosenMode FakeCamera::agreed() const {
  const std::scoped_lock lock(mutex_);
  return agreed_;
}

void FakeCamera::expect(bool kept, const char* rule) {
  if (!kept) broken_rules_.emplace_back(rule);
}

int FakeCamera::open(const char* path, int flags) {
  const std::scoped_lock lock(mutex_);
  ++opened_;
  expect((flags & O_NONBLOCK) != 0, "a camera is opened without blocking");
  std::error_code error;
  const auto real = std::filesystem::weakly_canonical(path, error);
  if (is_gone_ || real != std::filesystem::weakly_canonical(path_, error)) return failed(ENOENT);
  if (habits_.open_error != 0) return failed(habits_.open_error);
  descriptors_.insert(next_descriptor_);
  return next_descriptor_++;
}

int FakeCamera::close(int descriptor) {
  const std::scoped_lock lock(mutex_);
  expect(descriptors_.erase(descriptor) == 1, "only what is open is closed");
  dead_descriptors_.erase(descriptor);
  if (descriptors_.empty()) {
    bury_buffers();
    is_streaming_ = false;
  }
  return 0;
}

void* FakeCamera::mmap(std::size_t length, int, int, int descriptor, off_t offset) {
  const std::scoped_lock lock(mutex_);
  const auto index = static_cast<std::size_t>(offset);
  if (!descriptors_.contains(descriptor) || index >= buffers_.size() ||
      buffers_[index].memory.size() != length) {
    errno = EINVAL;
    return MAP_FAILED;
  }
  void* address = buffers_[index].memory.data();
  mapped_[address] = length;
  return address;
}

int FakeCamera::munmap(void* address, std::size_t length) {
  const std::scoped_lock lock(mutex_);
  const auto found = mapped_.find(address);
  expect(found != mapped_.end() && found->second == length, "only what is mapped is unmapped, whole");
  if (found != mapped_.end()) mapped_.erase(found);
  return 0;
}

int FakeCamera::poll(pollfd* descriptors, nfds_t count, int timeout_ms) {
  const auto wait = [&](Duration longest) {
    std::this_thread::sleep_for(std::min<Duration>(std::chrono::milliseconds(timeout_ms), longest));
    return 0;
  };
  Duration pace;
  Kind kind = Kind::Nothing;
  {
    const std::scoped_lock lock(mutex_);
    expect(count == 1 && timeout_ms >= 0, "waits for one device, and not forever");
    descriptors->revents = 0;
    pace = forever_interval_;
    if (is_gone_ || dead_descriptors_.contains(descriptors->fd)) {
      descriptors->revents = POLLERR | POLLHUP;
      return 1;
    }
    if (is_failing_) {
      descriptors->revents = POLLERR;
      return 1;
    }
    expose();
    if (!steps_.empty())
      kind = steps_.front().kind;
    else if (sensor_ && !exposed_.empty())
      kind = Kind::Picture;
    else if (forever_)
      kind = Kind::Picture;
    const bool ends_here =
        kind == Kind::Nothing || kind == Kind::Interrupted || kind == Kind::Gone || kind == Kind::Failing;
    if (ends_here && !steps_.empty()) steps_.pop_front();
    if (kind == Kind::Gone) {
      is_gone_ = true;
      dead_descriptors_ = descriptors_;
    }
    if (kind == Kind::Failing) is_failing_ = true;
  }
  switch (kind) {
    case Kind::Nothing:
      return wait(std::chrono::milliseconds(2));
    case Kind::Interrupted:
      return failed(EINTR);
    case Kind::NewSize:
      descriptors->revents = POLLPRI;
      return 1;
    case Kind::Gone:
    case Kind::Failing:
      descriptors->revents = POLLERR;
      return 1;
    default:
      descriptors->revents = POLLIN;
      if (steps_left() == 0 && !sensor_) wait(pace);  // the pace of an endless camera
      return 1;
  }
}

int FakeCamera::ioctl(int descriptor, unsigned long request, void* argument) {
  const std::scoped_lock lock(mutex_);
  if (!descriptors_.contains(descriptor)) return failed(EBADF);
  if (is_gone_ || dead_descriptors_.contains(descriptor)) return failed(ENODEV);
  const int reason = answer(descriptor, request, argument);
  return reason == 0 ? 0 : failed(reason);
}

int FakeCamera::answer(int, unsigned long request, void* argument) {
  switch (request) {
    case VIDIOC_QUERYCAP:
      return describe(argument);
    case VIDIOC_ENUM_FMT:
      return enumerate_format(argument);
    case VIDIOC_ENUM_FRAMESIZES:
      return enumerate_size(argument);
    case VIDIOC_ENUM_FRAMEINTERVALS:
      return enumerate_rate(argument);
    case VIDIOC_S_FMT:
    case VIDIOC_G_FMT:
      return set_format(argument);
    case VIDIOC_S_PARM:
    case VIDIOC_G_PARM:
      return set_rate(argument);
    case VIDIOC_REQBUFS:
      return request_buffers(argument);
    case VIDIOC_QUERYBUF:
      return query_buffer(argument);
    case VIDIOC_QBUF:
      return queue_buffer(argument);
    case VIDIOC_DQBUF:
      return dequeue_buffer(argument);
    case VIDIOC_STREAMON:
      return start();
    case VIDIOC_STREAMOFF:
      return stop();
    case VIDIOC_SUBSCRIBE_EVENT:
      return 0;
    case VIDIOC_DQEVENT:
      if (steps_.empty() || steps_.front().kind != Kind::NewSize) return ENOENT;
      steps_.pop_front();
      as<v4l2_event>(argument).type = V4L2_EVENT_SOURCE_CHANGE;
      as<v4l2_event>(argument).u.src_change.changes = V4L2_EVENT_SRC_CH_RESOLUTION;
      return 0;
    default:
      return ENOTTY;
  }
}

int FakeCamera::describe(void* argument) const {
  auto& facts = as<v4l2_capability>(argument);
  put_text(facts.card, habits_.name);
  put_text(facts.driver, habits_.driver);
  put_text(facts.bus_info, "usb-fake-1");
  facts.device_caps =
      (habits_.is_camera ? V4L2_CAP_VIDEO_CAPTURE : V4L2_CAP_VIDEO_OUTPUT) | V4L2_CAP_STREAMING;
  // The whole device can do more than this node.
  facts.capabilities = facts.device_caps | V4L2_CAP_DEVICE_CAPS | V4L2_CAP_VIDEO_CAPTURE;
  return 0;
}

int FakeCamera::enumerate_format(void* argument) const {
  auto& format = as<v4l2_fmtdesc>(argument);
  std::vector<std::uint32_t> formats;
  for (const CameraMode& mode : habits_.modes)
    if (std::find(formats.begin(), formats.end(), mode.pixel_format) == formats.end())
      formats.push_back(mode.pixel_format);
  if (format.index >= formats.size()) return EINVAL;
  format.pixelformat = formats[format.index];
  return 0;
}

int FakeCamera::enumerate_size(void* argument) const {
  auto& size = as<v4l2_frmsizeenum>(argument);
  std::uint32_t index = 0;
  for (const CameraMode& mode : habits_.modes) {
    if (mode.pixel_format != size.pixel_format || index++ != size.index) continue;
    size.type = V4L2_FRMSIZE_TYPE_DISCRETE;
    size.discrete = {static_cast<std::uint32_t>(mode.width), static_cast<std::uint32_t>(mode.height)};
    return 0;
  }
  return EINVAL;
}

int FakeCamera::enumerate_rate(void* argument) const {
  auto& rate = as<v4l2_frmivalenum>(argument);
  if (!habits_.tells_rates) return ENOTTY;
  for (const CameraMode& mode : habits_.modes) {
    if (mode.pixel_format != rate.pixel_format || static_cast<std::uint32_t>(mode.width) != rate.width ||
        static_cast<std::uint32_t>(mode.height) != rate.height || rate.index >= mode.frame_rates.size())
      continue;
    rate.type = V4L2_FRMIVAL_TYPE_DISCRETE;
    rate.discrete = {1000, static_cast<std::uint32_t>(std::lround(1000 * mode.frame_rates[rate.index]))};
    return 0;
  }
  return EINVAL;
}

std::size_t FakeCamera::picture_bytes() const {
  const auto width = static_cast<std::size_t>(agreed_.width),
             height = static_cast<std::size_t>(agreed_.height);
  if (is_jpeg(agreed_.pixel_format)) return 2 * width * height;
  const std::size_t row = width * bytes_a_pixel(agreed_.pixel_format) + habits_.row_padding_bytes;
  return agreed_.pixel_format == V4L2_PIX_FMT_NV12 ? row * (height + (height + 1) / 2) : row * height;
}

// Setting and asking answer alike.
int FakeCamera::set_format(void* argument) {
  auto& pixels = as<v4l2_format>(argument).fmt.pix;
  expect(as<v4l2_format>(argument).type == V4L2_BUF_TYPE_VIDEO_CAPTURE, "formats are of captured pictures");
  if (pixels.width > 0) {
    if (!buffers_.empty()) return EBUSY;
    agreed_.pixel_format = pixels.pixelformat;
    agreed_.width = static_cast<int>(pixels.width);
    agreed_.height = static_cast<int>(pixels.height);
  }
  if (habits_.only_width > 0) {
    agreed_.width = habits_.only_width;
    agreed_.height = habits_.only_height;
  }
  pixels.pixelformat = agreed_.pixel_format;
  pixels.width = static_cast<std::uint32_t>(agreed_.width);
  pixels.height = static_cast<std::uint32_t>(agreed_.height);
  pixels.bytesperline = is_jpeg(agreed_.pixel_format)
                            ? 0
                            : pixels.width * bytes_a_pixel(agreed_.pixel_format) +
                                  static_cast<std::uint32_t>(habits_.row_padding_bytes);
  pixels.sizeimage = static_cast<std::uint32_t>(picture_bytes());
  return 0;
}

int FakeCamera::set_rate(void* argument) {
  auto& capture = as<v4l2_streamparm>(argument).parm.capture;
  if (capture.timeperframe.numerator > 0)
    agreed_.fps = static_cast<double>(capture.timeperframe.denominator) / capture.timeperframe.numerator;
  capture.capability = V4L2_CAP_TIMEPERFRAME;
  capture.timeperframe = {1000, static_cast<std::uint32_t>(std::lround(1000 * agreed_.fps))};
  return 0;
}

void FakeCamera::bury_buffers() {
  for (Buffer& buffer : buffers_) graveyard_.push_back(std::move(buffer.memory));
  buffers_.clear();
  queued_.clear();
}

int FakeCamera::request_buffers(void* argument) {
  auto& request = as<v4l2_requestbuffers>(argument);
  if (is_streaming_) return EBUSY;
  expect(request.count > 0 || mapped_.empty(), "buffers are unmapped before they are given up");
  bury_buffers();
  buffers_.resize(std::min<std::uint32_t>(request.count, 4));
  for (Buffer& buffer : buffers_) buffer.memory.assign(std::max<std::size_t>(picture_bytes(), 1), 0);
  request.count = static_cast<std::uint32_t>(buffers_.size());
  return 0;
}

int FakeCamera::query_buffer(void* argument) {
  auto& buffer = as<v4l2_buffer>(argument);
  if (buffer.index >= buffers_.size()) return EINVAL;
  buffer.length = static_cast<std::uint32_t>(buffers_[buffer.index].memory.size());
  buffer.m.offset = buffer.index;
  return 0;
}

int FakeCamera::queue_buffer(void* argument) {
  const auto& buffer = as<v4l2_buffer>(argument);
  if (buffer.index >= buffers_.size()) return EINVAL;
  expect(!buffers_[buffer.index].is_queued, "a buffer is queued once");
  expect(buffer.memory == V4L2_MEMORY_MMAP && buffer.reserved == 0, "unused fields are zero");
  buffers_[buffer.index].is_queued = true;
  queued_.push_back(buffer.index);
  return 0;
}

int FakeCamera::dequeue_buffer(void* argument) {
  auto& out = as<v4l2_buffer>(argument);
  expect(is_streaming_, "buffers are taken from a running stream");
  if (is_failing_) return EIO;
  if (!steps_.empty() && steps_.front().kind == Kind::Again) {
    steps_.pop_front();
    return EAGAIN;
  }
  expose();
  const bool has_exposed = steps_.empty() && !exposed_.empty();
  const bool has_step = !steps_.empty();
  if (has_step && steps_.front().kind != Kind::Picture && steps_.front().kind != Kind::Flagged) return EAGAIN;
  if ((!has_step && !has_exposed && !forever_) || queued_.empty()) return EAGAIN;
  Step step;
  if (has_step) {
    step = std::move(steps_.front());
    steps_.pop_front();
  } else if (has_exposed) {
    step = std::move(exposed_.front());
    exposed_.pop_front();
  } else {
    step = {Kind::Picture, forever_(agreed_, next_sequence_), next_sequence_,
            std::chrono::steady_clock::now().time_since_epoch()};
  }
  next_sequence_ = step.sequence + 1;
  const std::uint32_t index = queued_.front();
  queued_.pop_front();
  Buffer& buffer = buffers_[index];
  buffer.is_queued = false;
  const std::size_t size = std::min(step.bytes.size(), buffer.memory.size());
  std::copy_n(step.bytes.begin(), size, buffer.memory.begin());
  out.index = index;
  out.bytesused = static_cast<std::uint32_t>(size);
  out.sequence = step.sequence;
  out.flags = (habits_.stamps_are_monotonic ? V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC : 0U) |
              (step.kind == Kind::Flagged ? V4L2_BUF_FLAG_ERROR : 0U);
  const auto microseconds = std::chrono::duration_cast<std::chrono::microseconds>(step.at).count();
  out.timestamp = {microseconds / 1'000'000, microseconds % 1'000'000};
  return 0;
}

int FakeCamera::start() {
  if (habits_.start_error != 0) return habits_.start_error;
  expect(!queued_.empty(), "a stream starts with buffers");
  ++started_;
  is_streaming_ = true;
  return 0;
}

int FakeCamera::stop() {
  is_streaming_ = is_failing_ = false;
  queued_.clear();
  for (Buffer& buffer : buffers_) buffer.is_queued = false;
  return 0;
}

}  // namespace posecoach
