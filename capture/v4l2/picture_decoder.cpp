#include "capture/v4l2/picture_decoder.h"

#include <linux/videodev2.h>

#include <algorithm>
#include <string>

namespace posecoach {
namespace {

// Where a raw format's bytes stand: rows of `bytes_a_row`, then, for some, another plane.
std::size_t least_bytes_a_row(std::uint32_t pixel_format, int width) {
  const auto pixels = static_cast<std::size_t>(width);
  switch (pixel_format) {
    case V4L2_PIX_FMT_YUYV:
    case V4L2_PIX_FMT_UYVY:
      return 2 * (pixels + pixels % 2);
    case V4L2_PIX_FMT_RGB24:
    case V4L2_PIX_FMT_BGR24:
      return 3 * pixels;
    case V4L2_PIX_FMT_NV12:
      return pixels + pixels % 2;
    default:
      return pixels;
  }
}

std::uint8_t clamped(int value) {
  return static_cast<std::uint8_t>(std::clamp(value, 0, 255));
}

// Fixed point with 16 bits behind the point.
struct YuvToRgb {
  int black, scale, red_v, green_u, green_v, blue_u;

  // Rec. ITU-R BT.601 and BT.709: Kr, Kb and the ranges of 8-bit video.
  static YuvToRgb make(bool is_full_range, bool is_rec709) {
    const double kr = is_rec709 ? 0.2126 : 0.299, kb = is_rec709 ? 0.0722 : 0.114, kg = 1 - kr - kb;
    const double luma = is_full_range ? 1 : 255.0 / 219, chroma = is_full_range ? 1 : 255.0 / 224;
    const auto fixed = [](double value) { return static_cast<int>(value * 65536 + 0.5); };
    return {is_full_range ? 0 : 16,
            fixed(luma),
            fixed(chroma * 2 * (1 - kr)),
            fixed(chroma * 2 * (1 - kb) * kb / kg),
            fixed(chroma * 2 * (1 - kr) * kr / kg),
            fixed(chroma * 2 * (1 - kb))};
  }

  void pixel(int y, int u, int v, std::uint8_t* rgb) const {
    const int luma = (y - black) * scale + (1 << 15);
    rgb[0] = clamped((luma + (v - 128) * red_v) >> 16);
    rgb[1] = clamped((luma - (u - 128) * green_u - (v - 128) * green_v) >> 16);
    rgb[2] = clamped((luma + (u - 128) * blue_u) >> 16);
  }
};

// Two pixels share a pair of colour values: y0 at byte `first`, u at `colour`.
void decode_packed_row(const std::uint8_t* row, int width, std::size_t first, std::size_t colour,
                       const YuvToRgb& convert, std::uint8_t* rgb) {
  for (int x = 0; x < width; ++x, rgb += 3) {
    const std::uint8_t* pair = row + 4 * (x / 2);
    convert.pixel(pair[first + 2 * static_cast<std::size_t>(x % 2)], pair[colour], pair[colour + 2], rgb);
  }
}

void decode_nv12_row(const std::uint8_t* luma, const std::uint8_t* chroma, int width, const YuvToRgb& convert,
                     std::uint8_t* rgb) {
  for (int x = 0; x < width; ++x, rgb += 3) {
    const std::uint8_t* pair = chroma + 2 * (x / 2);
    convert.pixel(luma[x], pair[0], pair[1], rgb);
  }
}

}  // namespace

bool can_decode(std::uint32_t pixel_format) {
  switch (pixel_format) {
    case V4L2_PIX_FMT_MJPEG:
    case V4L2_PIX_FMT_JPEG:
    case V4L2_PIX_FMT_YUYV:
    case V4L2_PIX_FMT_UYVY:
    case V4L2_PIX_FMT_NV12:
    case V4L2_PIX_FMT_RGB24:
    case V4L2_PIX_FMT_BGR24:
    case V4L2_PIX_FMT_GREY:
      return true;
    default:
      return false;
  }
}

Result<Image> PictureDecoder::decode(std::span<const std::uint8_t> bytes) {
  const std::uint32_t format = format_.pixel_format;
  if (format == V4L2_PIX_FMT_MJPEG || format == V4L2_PIX_FMT_JPEG) return jpeg_.decode(bytes);
  const std::size_t stride = std::max(format_.bytes_a_row, least_bytes_a_row(format, format_.width));
  const auto height = static_cast<std::size_t>(format_.height);
  const std::size_t rows = format == V4L2_PIX_FMT_NV12 ? height + (height + 1) / 2 : height;
  // The last row may lack its padding.
  const std::size_t needed = stride * (rows - 1) + least_bytes_a_row(format, format_.width);
  if (bytes.size() < needed)
    return fail(ErrorCode::Malformed, "a picture cut short: " + std::to_string(bytes.size()) + " of " +
                                          std::to_string(needed) + " bytes");
  Image image = Image::black(format_.width, format_.height);
  const YuvToRgb convert = YuvToRgb::make(format_.has_full_range, format_.has_rec709_colours);
  for (std::size_t y = 0; y < height; ++y) {
    const std::uint8_t* row = bytes.data() + y * stride;
    std::uint8_t* rgb = image.pixel(0, static_cast<int>(y));
    const auto row_bytes = 3 * static_cast<std::ptrdiff_t>(format_.width);
    switch (format) {
      case V4L2_PIX_FMT_YUYV:
        decode_packed_row(row, format_.width, 0, 1, convert, rgb);
        break;
      case V4L2_PIX_FMT_UYVY:
        decode_packed_row(row, format_.width, 1, 0, convert, rgb);
        break;
      case V4L2_PIX_FMT_NV12:
        decode_nv12_row(row, bytes.data() + (height + y / 2) * stride, format_.width, convert, rgb);
        break;
      case V4L2_PIX_FMT_RGB24:
        std::copy_n(row, row_bytes, rgb);
        break;
      case V4L2_PIX_FMT_BGR24:
        for (std::ptrdiff_t i = 0; i < row_bytes; i += 3) {
          rgb[i] = row[i + 2];
          rgb[i + 1] = row[i + 1];
          rgb[i + 2] = row[i];
        }
        break;
      default:
        for (std::ptrdiff_t x = 0; x < format_.width; ++x) std::fill_n(rgb + 3 * x, 3, row[x]);
    }
  }
  return image;
}

}  // namespace posecoach
