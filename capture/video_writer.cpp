#include "capture/video_writer.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/imgutils.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "capture/ffmpeg.h"
#include "capture/sound_track.h"
#include "core/base/atomic_file.h"

namespace posecoach {
namespace fs = std::filesystem;
namespace {

// Fine enough for any camera, coarse enough for every player.
constexpr AVRational kTimeBase = {1, 90000};

struct FreeMuxer {
  void operator()(AVFormatContext* context) const {
    if (context->pb != nullptr) avio_closep(&context->pb);
    avformat_free_context(context);
  }
};

Error write_error(const fs::path& path, int reason) {
  const ErrorCode code = reason == AVERROR(ENOENT)                                ? ErrorCode::NotFound
                         : reason == AVERROR(ENOMEM) || reason == AVERROR(EINVAL) ? ErrorCode::Internal
                                                                                  : ErrorCode::Unreadable;
  return {code, "cannot write " + path.string() + ": " + ffmpeg_reason(reason)};
}

}  // namespace

class VideoWriter::Implementation {
 public:
  Implementation(const fs::path& path, const VideoWriterOptions& options)
      : path_(behind_links(path)),
        temporary_(path_.string() + ".tmp" + std::to_string(::getpid()) + ".mp4"),
        options_(options) {}

  ~Implementation() {
    format_.reset();
    if (!finished_) ::unlink(temporary_.c_str());
  }

  Result<void> open() {
    keep_ffmpeg_quiet();
    // An MP4's index is written last and read first: it cannot go down a pipe.
    if (path_ == "-" || is_special_file(path_))
      return fail(ErrorCode::InvalidArgument,
                  "cannot write " + path_.string() + ": a film needs a file, not a device or a pipe");
    if (auto opened = open_encoder(); !opened) return opened;
    AVFormatContext* format = nullptr;
    if (const int made = avformat_alloc_output_context2(&format, nullptr, "mp4", temporary_.c_str());
        made < 0)
      return failed(made);
    format_.reset(format);
    stream_ = avformat_new_stream(format, nullptr);
    if (stream_ == nullptr) return failed(AVERROR(ENOMEM));
    stream_->time_base = kTimeBase;
    stream_->avg_frame_rate = av_d2q(options_.nominal_fps, 100000);
    if (const int copied = avcodec_parameters_from_context(stream_->codecpar, encoder_.get()); copied < 0)
      return failed(copied);
    if (options_.sound_from) {
      Result<std::unique_ptr<SoundTrack>> sound = SoundTrack::open(*options_.sound_from, *format);
      if (!sound) return tl::unexpected(sound.error());
      sound_ = *std::move(sound);
    }
    if (const int opened = avio_open(&format->pb, temporary_.c_str(), AVIO_FLAG_WRITE); opened < 0)
      return failed(opened);
    AVDictionary* settings = nullptr;
    av_dict_set(&settings, "movflags", "+faststart", 0);
    const int begun = avformat_write_header(format, &settings);
    av_dict_free(&settings);
    return begun < 0 ? failed(begun) : Result<void>();
  }

  Result<void> write(const Image& picture, MediaTime time) {
    if (picture.width != options_.width || picture.height != options_.height)
      return fail(ErrorCode::InvalidArgument,
                  "cannot write " + path_.string() + ": a picture is " + std::to_string(picture.width) + "x" +
                      std::to_string(picture.height) + ", the film " + std::to_string(options_.width) + "x" +
                      std::to_string(options_.height));
    // Sound has its own place in time; without it the film starts with its first picture.
    if (!first_) first_ = sound_ ? std::min(time, MediaTime()) : time;
    const auto ticks = static_cast<std::int64_t>(std::llround(to_seconds(time - *first_) * kTimeBase.den));
    if (ticks <= last_ticks_)
      return fail(ErrorCode::InvalidArgument, "cannot write " + path_.string() + ": time does not increase");
    if (const int ready = av_frame_make_writable(frame_.get()); ready < 0) return failed(ready);
    convert(picture);
    frame_->pts = ticks;
    previous_step_ = last_ticks_ < 0 ? 0 : ticks - last_ticks_;
    last_ticks_ = ticks;
    if (const int sent = avcodec_send_frame(encoder_.get(), frame_.get()); sent < 0) return failed(sent);
    return drain();
  }

  Result<void> finish() {
    if (last_ticks_ < 0)
      return fail(ErrorCode::Incomplete, "cannot write " + path_.string() + ": no pictures");
    if (const int sent = avcodec_send_frame(encoder_.get(), nullptr); sent < 0) return failed(sent);
    if (auto drained = drain(); !drained) return drained;
    if (sound_) {
      const double seconds = static_cast<double>(last_ticks_ + last_duration()) / kTimeBase.den;
      if (const int copied = sound_->copy_until(*format_, seconds, to_seconds(MediaTime() - *first_));
          copied < 0)
        return failed(copied);
    }
    if (const int ended = av_write_trailer(format_.get()); ended < 0) return failed(ended);
    if (const int closed = avio_closep(&format_->pb); closed < 0) return failed(closed);
    if (std::rename(temporary_.c_str(), path_.c_str()) != 0) return failed(AVERROR(errno));
    finished_ = true;
    return {};
  }

 private:
  tl::unexpected<Error> failed(int reason) const { return tl::unexpected(write_error(path_, reason)); }

  Result<void> open_encoder() {
    if (options_.width < 2 || options_.height < 2 || options_.width > 16384 || options_.height > 16384)
      return fail(ErrorCode::InvalidArgument, "cannot write " + path_.string() + ": a film of " +
                                                  std::to_string(options_.width) + "x" +
                                                  std::to_string(options_.height) + " pixels");
    const AVCodec* codec = avcodec_find_encoder_by_name("libx264");
    if (codec == nullptr) codec = avcodec_find_encoder(AV_CODEC_ID_H264);
    if (codec == nullptr)
      return fail(ErrorCode::Unsupported,
                  "cannot write " + path_.string() + ": this system's FFmpeg has no H.264 encoder (libx264)");
    encoder_.reset(avcodec_alloc_context3(codec));
    encoder_->width = even(options_.width);
    encoder_->height = even(options_.height);
    encoder_->pix_fmt = AV_PIX_FMT_YUV420P;
    encoder_->time_base = kTimeBase;
    encoder_->framerate = av_d2q(options_.nominal_fps > 0 ? options_.nominal_fps : 30, 100000);
    encoder_->color_range = AVCOL_RANGE_MPEG;
    encoder_->colorspace = AVCOL_SPC_BT709;
    encoder_->color_primaries = AVCOL_PRI_BT709;
    encoder_->color_trc = AVCOL_TRC_BT709;
    encoder_->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    // One thread gives the same file whatever the machine.
    encoder_->thread_count = 1;
    av_opt_set(encoder_->priv_data, "preset", "veryfast", 0);
    av_opt_set_int(encoder_->priv_data, "crf", options_.quality, 0);
    if (const int opened = avcodec_open2(encoder_.get(), codec, nullptr); opened < 0) return failed(opened);

    frame_.reset(av_frame_alloc());
    packet_.reset(av_packet_alloc());
    frame_->format = encoder_->pix_fmt;
    frame_->width = encoder_->width;
    frame_->height = encoder_->height;
    if (const int made = av_frame_get_buffer(frame_.get(), 0); made < 0) return failed(made);
    scaler_.reset(sws_getContext(encoder_->width, encoder_->height, AV_PIX_FMT_RGB24, encoder_->width,
                                 encoder_->height, AV_PIX_FMT_YUV420P, SWS_BILINEAR, nullptr, nullptr,
                                 nullptr));
    if (!scaler_) return failed(AVERROR(EINVAL));
    const int* to_video = sws_getCoefficients(SWS_CS_ITU709);
    sws_setColorspaceDetails(scaler_.get(), to_video, 1, to_video, 0, 0, 1 << 16, 1 << 16);
    return {};
  }

  // The padding of an odd size repeats the last column and row.
  void convert(const Image& picture) {
    const std::uint8_t* rows = picture.rgb.data();
    const int width = encoder_->width, height = encoder_->height;
    if (width != picture.width || height != picture.height) {
      padded_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
          std::copy_n(picture.pixel(std::min(x, picture.width - 1), std::min(y, picture.height - 1)), 3,
                      &padded_[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                    static_cast<std::size_t>(x))]);
      rows = padded_.data();
    }
    const int stride = 3 * width;
    sws_scale(scaler_.get(), &rows, &stride, 0, height, frame_->data, frame_->linesize);
  }

  std::int64_t last_duration() const {
    if (previous_step_ > 0) return previous_step_;
    return std::llround(kTimeBase.den / (options_.nominal_fps > 0 ? options_.nominal_fps : 30));
  }

  Result<void> drain() {
    for (;;) {
      const int got = avcodec_receive_packet(encoder_.get(), packet_.get());
      if (got == AVERROR(EAGAIN) || got == AVERROR_EOF) return {};
      if (got < 0) return failed(got);
      const double until_s = static_cast<double>(packet_->dts) / kTimeBase.den;
      if (packet_->pts == last_ticks_) packet_->duration = last_duration();
      packet_->stream_index = stream_->index;
      av_packet_rescale_ts(packet_.get(), kTimeBase, stream_->time_base);
      if (sound_) {
        if (const int copied = sound_->copy_until(*format_, until_s, to_seconds(MediaTime() - *first_));
            copied < 0)
          return failed(copied);
      }
      if (const int written = av_interleaved_write_frame(format_.get(), packet_.get()); written < 0)
        return failed(written);
      // The muxer hides a full disk in its buffer.
      if (format_->pb->error < 0) return failed(format_->pb->error);
    }
  }

  fs::path path_, temporary_;
  VideoWriterOptions options_;
  FfmpegPointer<AVCodecContext> encoder_;
  std::unique_ptr<AVFormatContext, FreeMuxer> format_;
  AVStream* stream_ = nullptr;  // of format_
  std::unique_ptr<SoundTrack> sound_;
  FfmpegPointer<SwsContext> scaler_;
  FfmpegPointer<AVFrame> frame_;
  FfmpegPointer<AVPacket> packet_;
  std::vector<std::uint8_t> padded_;
  std::optional<MediaTime> first_;
  std::int64_t last_ticks_ = -1, previous_step_ = 0;
  bool finished_ = false;
};

VideoWriter::VideoWriter(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
VideoWriter::~VideoWriter() = default;

Result<std::unique_ptr<VideoWriter>> VideoWriter::open(const fs::path& path,
                                                       const VideoWriterOptions& options) {
  auto implementation = std::make_unique<Implementation>(path, options);
  if (auto opened = implementation->open(); !opened) return tl::unexpected(opened.error());
  return std::unique_ptr<VideoWriter>(new VideoWriter(std::move(implementation)));
}

Result<void> VideoWriter::write(const Image& picture, MediaTime time) {
  return implementation_->write(picture, time);
}

Result<void> VideoWriter::finish() {
  return implementation_->finish();
}

}  // namespace posecoach
