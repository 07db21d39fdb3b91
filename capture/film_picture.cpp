#include "capture/film_picture.h"

extern "C" {
#include <libavutil/frame.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

#include <cmath>

namespace posecoach {
namespace {

constexpr std::size_t kRowAlignment = 64;

bool has_full_range(const AVFrame& frame) {
  switch (frame.format) {
    case AV_PIX_FMT_YUVJ420P:
    case AV_PIX_FMT_YUVJ411P:
    case AV_PIX_FMT_YUVJ422P:
    case AV_PIX_FMT_YUVJ440P:
    case AV_PIX_FMT_YUVJ444P:
      return true;
    default:
      return frame.color_range == AVCOL_RANGE_JPEG;
  }
}

// Width in square pixels. Ratios within two per cent are rounding left by other programs, not a wide film.
int square_width(const AVFrame& frame) {
  const AVRational shape = frame.sample_aspect_ratio;
  if (shape.num <= 0 || shape.den <= 0) return frame.width;
  const double ratio = av_q2d(shape);
  const double width = std::round(frame.width * ratio);
  return std::abs(ratio - 1) < 0.02 || width < 16 || width > 16384 ? frame.width : static_cast<int>(width);
}

}  // namespace

Result<Image> FilmPictureMaker::make(const AVFrame& frame) {
  if (width_ == 0) {
    width_ = square_width(frame);
    height_ = frame.height;
  }
  // FFmpeg's own default, so that pictures equal those of its tools: the "accurate" variants round colours
  // another way, which moves joints by up to a pixel.
  constexpr int kFlags = SWS_BICUBIC;
  const auto format = static_cast<AVPixelFormat>(frame.format);
  context_.reset(sws_getCachedContext(context_.release(), frame.width, frame.height, format, width_, height_,
                                      AV_PIX_FMT_RGB24, kFlags, nullptr, nullptr, nullptr));
  if (!context_) {
    const char* name = av_get_pix_fmt_name(format);
    return fail(ErrorCode::Unsupported, std::string("pictures of the pixel format ") +
                                            (name == nullptr ? "unknown" : name) + " cannot be converted");
  }
  sws_setColorspaceDetails(context_.get(), sws_getCoefficients(frame.colorspace),
                           has_full_range(frame) ? 1 : 0, sws_getCoefficients(SWS_CS_DEFAULT), 1, 0, 1 << 16,
                           1 << 16);
  // The conversion may write a little past a row's end: aligned rows of our own take it.
  const std::size_t stride =
      (3 * static_cast<std::size_t>(width_) + kRowAlignment) / kRowAlignment * kRowAlignment + kRowAlignment;
  rows_.resize(stride * static_cast<std::size_t>(height_) + kRowAlignment);
  std::uint8_t* const planes[4] = {rows_.data(), nullptr, nullptr, nullptr};
  const int strides[4] = {static_cast<int>(stride), 0, 0, 0};
  if (sws_scale(context_.get(), frame.data, frame.linesize, 0, frame.height, planes, strides) != height_)
    return fail(ErrorCode::Internal, "a picture could not be converted to RGB");
  return upright_copy({rows_.data(), stride, width_, height_}, orientation_);
}

}  // namespace posecoach
