#include "capture/sound_track.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
}

#include <algorithm>
#include <cmath>

#include "capture/ffmpeg.h"
#include "core/base/log.h"

namespace posecoach {

class SoundTrack::Implementation {
 public:
  FfmpegInput input;
  int input_stream = -1, output_stream = -1;
  double start_s = 0;  // of the old film: the earliest of its streams
  FfmpegPointer<AVPacket> packet{av_packet_alloc()};
  bool has_packet = false, at_end = false;
  std::int64_t last_dts = AV_NOPTS_VALUE;

  // Leaves the next sound packet in `packet`.
  bool fetch() {
    while (!has_packet && !at_end) {
      if (av_read_frame(input.get(), packet.get()) < 0)
        at_end = true;
      else if (packet->stream_index == input_stream && packet->pts != AV_NOPTS_VALUE)
        has_packet = true;
      else
        av_packet_unref(packet.get());
    }
    return has_packet;
  }
};

SoundTrack::SoundTrack(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
SoundTrack::~SoundTrack() = default;

Result<std::unique_ptr<SoundTrack>> SoundTrack::open(const std::filesystem::path& path,
                                                     AVFormatContext& film) {
  AVFormatContext* opened = nullptr;
  if (const int result = avformat_open_input(&opened, path.c_str(), nullptr, nullptr); result < 0)
    return fail(result == AVERROR(ENOENT)       ? ErrorCode::NotFound
                : result == AVERROR_INVALIDDATA ? ErrorCode::Malformed
                                                : ErrorCode::Unreadable,
                "cannot take the sound of " + path.string() + ": " + ffmpeg_reason(result));
  auto implementation = std::make_unique<Implementation>();
  implementation->input.reset(opened);
  if (const int result = avformat_find_stream_info(opened, nullptr); result < 0)
    return fail(ErrorCode::Malformed,
                "cannot take the sound of " + path.string() + ": " + ffmpeg_reason(result));
  implementation->input_stream = av_find_best_stream(opened, AVMEDIA_TYPE_AUDIO, -1, -1, nullptr, 0);
  if (implementation->input_stream < 0) return std::unique_ptr<SoundTrack>();
  const AVStream* source = opened->streams[implementation->input_stream];
  if (avformat_query_codec(film.oformat, source->codecpar->codec_id, FF_COMPLIANCE_NORMAL) != 1) {
    log::warning("the sound of " + path.string() +
                 " is of a kind that an MP4 cannot hold; the film stays silent");
    return std::unique_ptr<SoundTrack>();
  }
  if (opened->start_time != AV_NOPTS_VALUE)
    implementation->start_s = static_cast<double>(opened->start_time) / AV_TIME_BASE;

  AVStream* stream = avformat_new_stream(&film, nullptr);
  if (stream == nullptr || avcodec_parameters_copy(stream->codecpar, source->codecpar) < 0)
    return fail(ErrorCode::Internal, "cannot take the sound of " + path.string() + ": out of memory");
  stream->codecpar->codec_tag = 0;
  stream->time_base = source->time_base;
  implementation->output_stream = stream->index;
  return std::unique_ptr<SoundTrack>(new SoundTrack(std::move(implementation)));
}

int SoundTrack::copy_until(AVFormatContext& film, double seconds, double later_s) {
  Implementation& track = *implementation_;
  const AVRational from = track.input->streams[track.input_stream]->time_base;
  const AVRational to = film.streams[track.output_stream]->time_base;
  while (track.fetch()) {
    const double begins_s = static_cast<double>(track.packet->pts) * av_q2d(from) - track.start_s + later_s;
    if (begins_s >= seconds) return 0;  // kept for the next call
    track.has_packet = false;
    if (begins_s < 0) {
      av_packet_unref(track.packet.get());
      continue;
    }
    const auto shift = static_cast<std::int64_t>(std::llround((later_s - track.start_s) / av_q2d(from)));
    track.packet->pts += shift;
    track.packet->dts = track.packet->dts == AV_NOPTS_VALUE ? track.packet->pts : track.packet->dts + shift;
    av_packet_rescale_ts(track.packet.get(), from, to);
    if (track.last_dts != AV_NOPTS_VALUE && track.packet->dts <= track.last_dts)
      track.packet->dts = track.last_dts + 1;
    track.packet->pts = std::max(track.packet->pts, track.packet->dts);
    track.last_dts = track.packet->dts;
    track.packet->stream_index = track.output_stream;
    track.packet->pos = -1;
    if (const int written = av_interleaved_write_frame(&film, track.packet.get()); written < 0)
      return written;
  }
  return 0;
}

}  // namespace posecoach
