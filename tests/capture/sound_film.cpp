#include "tests/capture/sound_film.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/channel_layout.h>
}

#include <algorithm>
#include <cmath>

namespace posecoach {

bool write_sound_film(const std::filesystem::path& path, double seconds) {
  constexpr int kRate = 44100;
  const AVCodec* codec = avcodec_find_encoder(AV_CODEC_ID_AAC);
  AVFormatContext* film = nullptr;
  if (codec == nullptr || avformat_alloc_output_context2(&film, nullptr, "mp4", path.c_str()) < 0)
    return false;
  AVCodecContext* encoder = avcodec_alloc_context3(codec);
  encoder->sample_rate = kRate;
  encoder->sample_fmt = AV_SAMPLE_FMT_FLTP;
  encoder->bit_rate = 64000;
  encoder->time_base = {1, kRate};
  encoder->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
  av_channel_layout_default(&encoder->ch_layout, 1);
  AVStream* stream = avformat_new_stream(film, nullptr);
  bool good = avcodec_open2(encoder, codec, nullptr) >= 0 &&
              avcodec_parameters_from_context(stream->codecpar, encoder) >= 0 &&
              avio_open(&film->pb, path.c_str(), AVIO_FLAG_WRITE) >= 0;
  stream->time_base = encoder->time_base;
  good = good && avformat_write_header(film, nullptr) >= 0;
  AVFrame* frame = av_frame_alloc();
  AVPacket* packet = av_packet_alloc();
  if (good) {
    frame->format = encoder->sample_fmt;
    frame->nb_samples = encoder->frame_size;
    frame->sample_rate = kRate;
    av_channel_layout_copy(&frame->ch_layout, &encoder->ch_layout);
    good = av_frame_get_buffer(frame, 0) >= 0;
  }
  const auto drain = [&] {
    while (good && avcodec_receive_packet(encoder, packet) >= 0) {
      av_packet_rescale_ts(packet, encoder->time_base, stream->time_base);
      packet->stream_index = stream->index;
      good = av_interleaved_write_frame(film, packet) >= 0;
    }
  };
  for (std::int64_t sample = 0; good && static_cast<double>(sample) < seconds * kRate;
       sample += frame->nb_samples) {
    good = av_frame_make_writable(frame) >= 0;
    auto* values = reinterpret_cast<float*>(frame->data[0]);
    for (int i = 0; i < frame->nb_samples; ++i)
      values[i] = 0.3F * std::sin(0.06F * static_cast<float>(sample + i));
    frame->pts = sample;
    good = good && avcodec_send_frame(encoder, frame) >= 0;
    drain();
  }
  if (good) {
    avcodec_send_frame(encoder, nullptr);
    drain();
    good = av_write_trailer(film) >= 0;
  }
  av_packet_free(&packet);
  av_frame_free(&frame);
  avcodec_free_context(&encoder);
  if (film->pb != nullptr) avio_closep(&film->pb);
  avformat_free_context(film);
  return good;
}

std::optional<std::pair<double, double>> sound_seconds(const std::filesystem::path& path) {
  AVFormatContext* film = nullptr;
  if (avformat_open_input(&film, path.c_str(), nullptr, nullptr) < 0) return std::nullopt;
  std::optional<std::pair<double, double>> span;
  if (avformat_find_stream_info(film, nullptr) >= 0) {
    const int stream = av_find_best_stream(film, AVMEDIA_TYPE_AUDIO, -1, -1, nullptr, 0);
    AVPacket* packet = av_packet_alloc();
    while (stream >= 0 && av_read_frame(film, packet) >= 0) {
      if (packet->stream_index == stream) {
        const double unit = av_q2d(film->streams[stream]->time_base);
        const double begin = static_cast<double>(packet->pts) * unit;
        const double end = begin + static_cast<double>(packet->duration) * unit;
        span = span ? std::pair(std::min(span->first, begin), std::max(span->second, end))
                    : std::pair(begin, end);
      }
      av_packet_unref(packet);
    }
    av_packet_free(&packet);
  }
  avformat_close_input(&film);
  return span;
}

}  // namespace posecoach
