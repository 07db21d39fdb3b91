#include "capture/v4l2/device.h"

#include <fcntl.h>
#include <linux/videodev2.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <utility>

#include "capture/v4l2/picture_decoder.h"
#include "capture/v4l2/system_calls.h"

namespace posecoach {
namespace {

// Sizes to offer where a camera takes any.
constexpr std::array<std::pair<int, int>, 6> kUsualSizes = {
    {{3840, 2160}, {1920, 1080}, {1280, 720}, {800, 600}, {640, 480}, {320, 240}}};
constexpr std::array<double, 8> kUsualRates = {240, 120, 90, 60, 50, 30, 25, 15};
constexpr std::uint32_t kMostEntries = 256;  // a driver that never says "no more" must not keep us

template <std::size_t size>
std::string text_of(const unsigned char (&field)[size]) {
  return {reinterpret_cast<const char*>(field), ::strnlen(reinterpret_cast<const char*>(field), size)};
}

double rate_of(const v4l2_fract& interval) {
  return interval.numerator == 0 ? 0 : static_cast<double>(interval.denominator) / interval.numerator;
}

AgreedFormat agreed_from(const v4l2_pix_format& format) {
  AgreedFormat agreed;
  agreed.pixel_format = format.pixelformat;
  agreed.width = static_cast<int>(format.width);
  agreed.height = static_cast<int>(format.height);
  agreed.bytes_a_row = format.bytesperline;
  agreed.bytes_a_picture = format.sizeimage;
  agreed.has_full_range = format.quantization == V4L2_QUANTIZATION_FULL_RANGE;
  agreed.has_rec709_colours =
      format.ycbcr_enc == V4L2_YCBCR_ENC_709 ||
      (format.ycbcr_enc == V4L2_YCBCR_ENC_DEFAULT && format.colorspace == V4L2_COLORSPACE_REC709);
  return agreed;
}

}  // namespace

Result<V4l2Device> V4l2Device::open(const std::filesystem::path& path, V4l2SystemCalls& calls) {
  int descriptor = -1;
  do {
    descriptor = calls.open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  } while (descriptor < 0 && errno == EINTR);
  V4l2Device device(path, descriptor, calls);
  if (descriptor < 0) return tl::unexpected(device.error("cannot be opened", errno));
  if (auto identified = device.identify(); !identified) return tl::unexpected(identified.error());
  return device;
}

V4l2Device::V4l2Device(std::filesystem::path path, int descriptor, V4l2SystemCalls& calls)
    : path_(std::move(path)), descriptor_(descriptor), calls_(&calls) {}

V4l2Device::V4l2Device(V4l2Device&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      calls_(other.calls_),
      name_(std::move(other.name_)),
      driver_(std::move(other.driver_)),
      bus_(std::move(other.bus_)) {}

V4l2Device::~V4l2Device() {
  if (descriptor_ >= 0) calls_->close(descriptor_);
}

int V4l2Device::control(unsigned long request, void* argument) const {
  while (calls_->ioctl(descriptor_, request, argument) < 0)
    if (errno != EINTR) return errno;
  return 0;
}

Error V4l2Device::error(std::string_view what, int reason) const {
  const auto say = [&](ErrorCode code, const std::string& words) {
    return Error{code, one_line("camera " + path_.string() + " " + std::string(what) + ": " + words)};
  };
  switch (reason) {
    case ENOENT:
      return say(ErrorCode::NotFound, "there is no such device; `posecoach cameras` lists those there are");
    case EACCES:
    case EPERM:
      return say(ErrorCode::Unreadable,
                 "no permission; join the group \"video\" (sudo usermod -aG video $USER) and log in again");
    case EBUSY:
      return say(ErrorCode::Unreadable, "another program uses it; close that first");
    case ENODEV:
    case ENXIO:
      return say(ErrorCode::DeviceLost, "it was unplugged");
    case ENOSPC:
      return say(ErrorCode::Unsupported,
                 "its USB bus is too busy for this mode; choose a smaller size or another port");
    case ENOTTY:
      return say(ErrorCode::Unsupported, "this device is no camera");
    default:
      return say(ErrorCode::Unreadable, std::strerror(reason));
  }
}

Result<void> V4l2Device::identify() {
  v4l2_capability facts = {};
  if (const int failed = control(VIDIOC_QUERYCAP, &facts))
    return tl::unexpected(error("cannot be used", failed));
  const std::uint32_t can =
      (facts.capabilities & V4L2_CAP_DEVICE_CAPS) != 0 ? facts.device_caps : facts.capabilities;
  name_ = text_of(facts.card);
  driver_ = text_of(facts.driver);
  bus_ = text_of(facts.bus_info);
  if ((can & V4L2_CAP_VIDEO_CAPTURE) == 0) return tl::unexpected(error("cannot be used", ENOTTY));
  if ((can & V4L2_CAP_STREAMING) == 0)
    return tl::unexpected(Error{ErrorCode::Unsupported, "camera " + path_.string() + " cannot stream"});
  return {};
}

std::vector<double> V4l2Device::frame_rates(std::uint32_t format, int width, int height) const {
  std::vector<double> rates;
  for (std::uint32_t i = 0; i < kMostEntries; ++i) {
    v4l2_frmivalenum interval = {};
    interval.index = i;
    interval.pixel_format = format;
    interval.width = static_cast<std::uint32_t>(width);
    interval.height = static_cast<std::uint32_t>(height);
    if (control(VIDIOC_ENUM_FRAMEINTERVALS, &interval) != 0) break;
    if (interval.type == V4L2_FRMIVAL_TYPE_DISCRETE) {
      rates.push_back(rate_of(interval.discrete));
      continue;
    }
    const double fastest = rate_of(interval.stepwise.min), slowest = rate_of(interval.stepwise.max);
    rates.push_back(fastest);
    for (const double rate : kUsualRates)
      if (rate < fastest && rate >= slowest) rates.push_back(rate);
    break;
  }
  std::erase_if(rates, [](double rate) { return !(rate > 0) || rate > 10000; });
  std::sort(rates.begin(), rates.end(), std::greater<>());
  rates.erase(std::unique(rates.begin(), rates.end()), rates.end());
  return rates;
}

void V4l2Device::add_sizes(std::uint32_t format, std::vector<CameraMode>& modes) const {
  const auto add = [&](std::uint32_t width, std::uint32_t height) {
    if (width < 1 || height < 1 || width > 8192 || height > 8192) return;
    const int w = static_cast<int>(width), h = static_cast<int>(height);
    modes.push_back({format, w, h, frame_rates(format, w, h)});
  };
  for (std::uint32_t i = 0; i < kMostEntries; ++i) {
    v4l2_frmsizeenum size = {};
    size.index = i;
    size.pixel_format = format;
    if (control(VIDIOC_ENUM_FRAMESIZES, &size) != 0) break;
    if (size.type == V4L2_FRMSIZE_TYPE_DISCRETE) {
      add(size.discrete.width, size.discrete.height);
      continue;
    }
    const v4l2_frmsize_stepwise& range = size.stepwise;
    const auto fits = [](std::uint32_t value, std::uint32_t least, std::uint32_t most, std::uint32_t step) {
      return value >= least && value <= most && (step == 0 || (value - least) % step == 0);
    };
    for (const auto& [width, height] : kUsualSizes) {
      const auto w = static_cast<std::uint32_t>(width), h = static_cast<std::uint32_t>(height);
      if (fits(w, range.min_width, range.max_width, range.step_width) &&
          fits(h, range.min_height, range.max_height, range.step_height))
        add(w, h);
    }
    break;
  }
}

std::vector<CameraMode> V4l2Device::modes() const {
  std::vector<CameraMode> modes;
  for (std::uint32_t i = 0; i < kMostEntries; ++i) {
    v4l2_fmtdesc format = {};
    format.index = i;
    format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    if (control(VIDIOC_ENUM_FMT, &format) != 0) break;
    if (can_decode(format.pixelformat)) add_sizes(format.pixelformat, modes);
  }
  std::stable_sort(modes.begin(), modes.end(), [](const CameraMode& a, const CameraMode& b) {
    return a.width * a.height > b.width * b.height;
  });
  return modes;
}

Result<AgreedFormat> V4l2Device::agreed() const {
  v4l2_format format = {};
  format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  if (const int failed = control(VIDIOC_G_FMT, &format))
    return tl::unexpected(error("does not tell its format", failed));
  return agreed_from(format.fmt.pix);
}

double V4l2Device::set_rate(double fps) const {
  v4l2_streamparm parameters = {};
  parameters.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  // Without rates to choose from the driver's own is as good as any.
  if (control(VIDIOC_G_PARM, &parameters) != 0) return 0;
  v4l2_captureparm& capture = parameters.parm.capture;
  if (fps > 0 && (capture.capability & V4L2_CAP_TIMEPERFRAME) != 0) {
    v4l2_streamparm wanted = {};
    wanted.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    wanted.parm.capture.timeperframe = {1000, static_cast<std::uint32_t>(std::lround(1000 * fps))};
    if (control(VIDIOC_S_PARM, &wanted) == 0) parameters = wanted;
  }
  return rate_of(capture.timeperframe);
}

Result<AgreedFormat> V4l2Device::agree(const ChosenMode& mode) {
  v4l2_format format = {};
  format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  format.fmt.pix.width = static_cast<std::uint32_t>(mode.width);
  format.fmt.pix.height = static_cast<std::uint32_t>(mode.height);
  format.fmt.pix.pixelformat = mode.pixel_format;
  format.fmt.pix.field = V4L2_FIELD_ANY;
  if (const int failed = control(VIDIOC_S_FMT, &format))
    return tl::unexpected(error("refuses a format", failed));
  AgreedFormat agreed = agreed_from(format.fmt.pix);
  if (!can_decode(agreed.pixel_format))
    return fail(ErrorCode::Unsupported, "camera " + path_.string() + " gives pictures as " +
                                            pixel_format_name(agreed.pixel_format) +
                                            ", which cannot be decoded");
  if (agreed.width < 2 || agreed.height < 2 || agreed.width > 8192 || agreed.height > 8192)
    return fail(ErrorCode::Unsupported, "camera " + path_.string() + " gives pictures of " +
                                            std::to_string(agreed.width) + "x" +
                                            std::to_string(agreed.height) + " pixels");
  agreed.fps = set_rate(mode.fps);
  return agreed;
}

}  // namespace posecoach
