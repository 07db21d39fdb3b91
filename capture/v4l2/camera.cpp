#include "capture/v4l2/camera.h"

#include <algorithm>

#include "capture/v4l2/system_calls.h"

namespace posecoach {
namespace {

using Clock = std::chrono::steady_clock;

// How long a stop may go unheard.
constexpr Duration kSlice = std::chrono::milliseconds(50);
// So many pictures of one other size are a change, fewer are damage.
constexpr int kOddPicturesAreAChange = 3;

std::string size_text(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

}  // namespace

Result<std::unique_ptr<V4l2Camera>> V4l2Camera::open(const V4l2CameraOptions& options) {
  V4l2SystemCalls& calls = options.system_calls == nullptr ? real_v4l2_system_calls() : *options.system_calls;
  Result<V4l2Device> device = V4l2Device::open(options.path, calls);
  if (!device) return tl::unexpected(device.error());
  const std::optional<ChosenMode> mode = choose_mode(device->modes(), options.wish);
  // A driver that lists nothing may still have set something that we know.
  const Result<AgreedFormat> format = mode ? device->agree(*mode) : device->agreed();
  if (!format) return tl::unexpected(format.error());
  if (!can_decode(format->pixel_format))
    return fail(ErrorCode::Unsupported,
                "camera " + options.path.string() + " has no picture format that can be decoded");
  std::unique_ptr<V4l2Camera> camera(new V4l2Camera(options, *std::move(device), *format));
  auto stream = BufferStream::start(camera->device_);
  if (!stream) return tl::unexpected(stream.error());
  camera->stream_ = *std::move(stream);
  camera->last_good_ = Clock::now();
  return camera;
}

V4l2Camera::V4l2Camera(const V4l2CameraOptions& options, V4l2Device device, const AgreedFormat& format)
    : options_(options), device_(std::move(device)), format_(format), decoder_(format) {
  info_.name = options.name.empty() ? options.path.string() : options.name;
  info_.width = format.width;
  info_.height = format.height;
  info_.nominal_fps = format.fps;
}

Result<std::optional<Frame>> V4l2Camera::next(std::stop_token stop) {
  for (;;) {
    if (stop.stop_requested()) return fail(ErrorCode::Cancelled, "interrupted while reading " + info_.name);
    const Result<std::optional<FilledBuffer>> filled = stream_->next(kSlice);
    if (!filled) return tl::unexpected(filled.error());
    if (*filled) {
      count((*filled)->sequence);
      Result<std::optional<Image>> image = picture_of(**filled);
      if (!image) return tl::unexpected(image.error());
      if (*image) return frame_of(*std::move(*image), (*filled)->captured_at);
      ++broken_;
    }
    if (Clock::now() - last_good_ > options_.longest_silence) {
      last_good_ = Clock::now();
      return fail(ErrorCode::DeviceLost,
                  "camera " + options_.path.string() +
                      (*filled ? " gives nothing but damaged pictures; try another cable "
                                 "or port"
                               : " gives no pictures; unplug it and plug it in again"));
    }
  }
}

void V4l2Camera::count(std::uint32_t sequence) {
  if (last_sequence_) {
    std::uint32_t step = sequence - *last_sequence_;  // wraps as the driver's count does
    if (step == 0 || step > 0x7FFFFFFF) step = 1;     // some drivers do not count, or start again
    index_ += step;
    lost_ += step - 1;
  }
  last_sequence_ = sequence;
}

Result<std::optional<Image>> V4l2Camera::picture_of(const FilledBuffer& buffer) {
  if (buffer.is_damaged) return std::nullopt;
  Result<Image> image = decoder_.decode(buffer.bytes);
  if (!image) return std::nullopt;
  const Result<bool> fits = has_the_films_size(*image);
  if (!fits) return tl::unexpected(fits.error());
  if (!*fits) return std::nullopt;
  return *std::move(image);
}

Result<bool> V4l2Camera::has_the_films_size(const Image& image) {
  const bool is_odd = image.width != info_.width || image.height != info_.height;
  const bool is_as_odd = is_odd && image.width == odd_width_ && image.height == odd_height_;
  odd_count_ = is_as_odd ? odd_count_ + 1 : is_odd ? 1 : 0;
  odd_width_ = image.width;
  odd_height_ = image.height;
  if (odd_count_ < kOddPicturesAreAChange) return !is_odd;
  if (delivered_ > 0)
    return fail(ErrorCode::DeviceLost, "camera " + options_.path.string() +
                                           " changed the size of its pictures from " +
                                           size_text(info_.width, info_.height) + " to " +
                                           size_text(image.width, image.height) + " and is opened again");
  // It never gave what it agreed to: then what it gives is its size.
  info_.width = image.width;
  info_.height = image.height;
  odd_count_ = 0;
  return true;
}

Frame V4l2Camera::frame_of(Image image, CaptureTime captured_at) {
  if (!first_stamp_)
    first_stamp_ = captured_at;
  else
    captured_at = std::max<CaptureTime>(captured_at, last_stamp_ + std::chrono::microseconds(1));
  last_stamp_ = captured_at;
  last_good_ = Clock::now();
  ++delivered_;
  return {index_, MediaTime(captured_at - *first_stamp_), captured_at,
          std::make_shared<const Image>(std::move(image))};
}

CameraStatistics V4l2Camera::statistics() const {
  return {delivered_, lost_, broken_};
}

}  // namespace posecoach
