#include "capture/picture_encoder.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

#include <algorithm>
#include <cmath>
#include <string>

#include "capture/ffmpeg.h"
#include "capture/padded_rows.h"
#include "core/image/image_codec.h"

namespace posecoach {
namespace {

constexpr int kJpegQuality = 90;
// Good to look at, small, and quick: ultrafast costs size, not quality.
constexpr double kH264Quality = 21;

tl::unexpected<Error> failed(int reason) {
  return fail(ErrorCode::Internal, "a picture cannot be compressed: " + ffmpeg_reason(reason));
}

class JpegPictures : public PictureEncoder {
 public:
  JpegPictures(int width, int height, double nominal_fps)
      : stream_{FilmCodec::Jpeg, width, height, nominal_fps, {}} {}

  const FilmStream& stream() const override { return stream_; }
  Result<EncodedPicture> encode(const Image& image) override {
    if (image.width == stream_.width && image.height == stream_.height)
      return EncodedPicture{encoder_.encode(image, kJpegQuality), true};
    return EncodedPicture{encoder_.encode(resized(image, stream_.width, stream_.height), kJpegQuality), true};
  }

 private:
  FilmStream stream_;
  JpegEncoder encoder_;
};

class H264Pictures : public PictureEncoder {
 public:
  const FilmStream& stream() const override { return stream_; }

  Result<void> open(int width, int height, double nominal_fps) {
    const AVCodec* codec = avcodec_find_encoder_by_name("libx264");
    if (codec == nullptr)
      return fail(ErrorCode::Unsupported, "this system's FFmpeg has no H.264 encoder (libx264)");
    encoder_.reset(avcodec_alloc_context3(codec));
    encoder_->width = width;
    encoder_->height = height;
    encoder_->pix_fmt = AV_PIX_FMT_YUV420P;
    // Only counts pictures: their times are the container's.
    encoder_->framerate = av_d2q(nominal_fps, 100000);
    encoder_->time_base = av_inv_q(encoder_->framerate);
    encoder_->color_range = AVCOL_RANGE_MPEG;
    encoder_->colorspace = AVCOL_SPC_BT709;
    encoder_->color_primaries = AVCOL_PRI_BT709;
    encoder_->color_trc = AVCOL_TRC_BT709;
    encoder_->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    encoder_->thread_count = 1;
    // Half a second from one complete picture to the next: quick to step and to repair.
    encoder_->gop_size = std::max(1, static_cast<int>(std::lround(nominal_fps / 2)));
    av_opt_set(encoder_->priv_data, "preset", "ultrafast", 0);
    av_opt_set(encoder_->priv_data, "tune", "zerolatency", 0);
    av_opt_set_double(encoder_->priv_data, "crf", kH264Quality, 0);
    if (const int opened = avcodec_open2(encoder_.get(), codec, nullptr); opened < 0) return failed(opened);
    frame_.reset(av_frame_alloc());
    packet_.reset(av_packet_alloc());
    frame_->format = encoder_->pix_fmt;
    frame_->width = width;
    frame_->height = height;
    if (const int made = av_frame_get_buffer(frame_.get(), 0); made < 0) return failed(made);
    stream_ = {FilmCodec::H264, width, height, nominal_fps,
               Bytes(encoder_->extradata, encoder_->extradata + encoder_->extradata_size)};
    return {};
  }

  Result<EncodedPicture> encode(const Image& image) override {
    if (const int ready = av_frame_make_writable(frame_.get()); ready < 0) return failed(ready);
    if (!convert(image)) return failed(AVERROR(EINVAL));
    frame_->pts = next_++;
    if (const int sent = avcodec_send_frame(encoder_.get(), frame_.get()); sent < 0) return failed(sent);
    if (const int got = avcodec_receive_packet(encoder_.get(), packet_.get()); got < 0) return failed(got);
    EncodedPicture picture{Bytes(packet_->data, packet_->data + packet_->size),
                           (packet_->flags & AV_PKT_FLAG_KEY) != 0};
    av_packet_unref(packet_.get());
    return picture;
  }

 private:
  bool convert(const Image& image) {
    scaler_.reset(sws_getCachedContext(scaler_.release(), image.width, image.height, AV_PIX_FMT_RGB24,
                                       encoder_->width, encoder_->height, AV_PIX_FMT_YUV420P,
                                       SWS_FAST_BILINEAR, nullptr, nullptr, nullptr));
    if (!scaler_) return false;
    const int* to_video = sws_getCoefficients(SWS_CS_ITU709);
    sws_setColorspaceDetails(scaler_.get(), to_video, 1, to_video, 0, 0, 1 << 16, 1 << 16);
    const std::uint8_t* rows = rows_.copy(image);
    const int stride = rows_.stride();
    return sws_scale(scaler_.get(), &rows, &stride, 0, image.height, frame_->data, frame_->linesize) ==
           encoder_->height;
  }

  FilmStream stream_;
  FfmpegPointer<AVCodecContext> encoder_;
  FfmpegPointer<AVFrame> frame_;
  FfmpegPointer<AVPacket> packet_;
  FfmpegPointer<SwsContext> scaler_;
  PaddedRows rows_;
  std::int64_t next_ = 0;
};

}  // namespace

Result<std::unique_ptr<PictureEncoder>> make_picture_encoder(FilmCodec codec, int width, int height,
                                                             double nominal_fps) {
  if (width < 2 || height < 2 || width > 8192 || height > 8192)
    return fail(ErrorCode::InvalidArgument, "a film of " + std::to_string(width) + "x" +
                                                std::to_string(height) + " pixels cannot be written");
  keep_ffmpeg_quiet();
  const double fps =
      std::isfinite(nominal_fps) && nominal_fps > 0 ? std::clamp(nominal_fps, 1.0, 1000.0) : 30;
  if (codec == FilmCodec::Jpeg) return std::make_unique<JpegPictures>(even(width), even(height), fps);
  auto pictures = std::make_unique<H264Pictures>();
  if (const auto opened = pictures->open(even(width), even(height), fps); !opened)
    return tl::unexpected(opened.error());
  return pictures;
}

}  // namespace posecoach
