#include "tests/capture/test_film.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
}

#include <cstring>
#include <random>
#include <string>

#include "core/base/assert.h"
#include "core/base/file.h"

namespace posecoach {
namespace {

constexpr AVRational kMilliseconds = {1, 1000};

AVCodecContext* open_encoder(const Image& picture) {
  const AVCodec* codec = avcodec_find_encoder(AV_CODEC_ID_PNG);
  POSECOACH_ASSERT(codec != nullptr);
  AVCodecContext* encoder = avcodec_alloc_context3(codec);
  encoder->width = picture.width;
  encoder->height = picture.height;
  encoder->pix_fmt = AV_PIX_FMT_RGB24;
  encoder->time_base = kMilliseconds;
  encoder->thread_count = 1;
  POSECOACH_ASSERT(avcodec_open2(encoder, codec, nullptr) == 0);
  return encoder;
}

void set_matrix(AVStream& stream, const std::array<int, 4>& matrix) {
  auto* stored = reinterpret_cast<std::int32_t*>(
      av_stream_new_side_data(&stream, AV_PKT_DATA_DISPLAYMATRIX, 9 * sizeof(std::int32_t)));
  std::memset(stored, 0, 9 * sizeof(std::int32_t));
  stored[0] = matrix[0] * 65536;
  stored[1] = matrix[1] * 65536;
  stored[3] = matrix[2] * 65536;
  stored[4] = matrix[3] * 65536;
  stored[8] = 1 << 30;
}

void write_picture(AVFormatContext& format, AVCodecContext& encoder, const Image& picture,
                   std::int64_t time_ms, std::int64_t duration_ms) {
  AVFrame* frame = av_frame_alloc();
  frame->format = AV_PIX_FMT_RGB24;
  frame->width = picture.width;
  frame->height = picture.height;
  POSECOACH_ASSERT(av_frame_get_buffer(frame, 0) == 0);
  const auto row_bytes = 3 * static_cast<std::size_t>(picture.width);
  for (int y = 0; y < picture.height; ++y)
    std::memcpy(frame->data[0] + std::ptrdiff_t{y} * frame->linesize[0], picture.pixel(0, y), row_bytes);
  frame->pts = time_ms;
  POSECOACH_ASSERT(avcodec_send_frame(&encoder, frame) == 0);
  AVPacket* packet = av_packet_alloc();
  POSECOACH_ASSERT(avcodec_receive_packet(&encoder, packet) == 0);
  packet->pts = packet->dts = time_ms;
  packet->duration = duration_ms;
  av_packet_rescale_ts(packet, kMilliseconds, format.streams[0]->time_base);
  POSECOACH_ASSERT(av_interleaved_write_frame(&format, packet) == 0);
  av_packet_free(&packet);
  av_frame_free(&frame);
}

}  // namespace

void write_test_film(const std::filesystem::path& path, const TestFilm& film) {
  AVFormatContext* format = nullptr;
  POSECOACH_ASSERT(avformat_alloc_output_context2(&format, nullptr, nullptr, path.c_str()) >= 0);
  AVCodecContext* encoder = open_encoder(film.pictures[0]);
  AVStream* stream = avformat_new_stream(format, nullptr);
  stream->time_base = kMilliseconds;
  avcodec_parameters_from_context(stream->codecpar, encoder);
  if (film.matrix) set_matrix(*stream, *film.matrix);
  POSECOACH_ASSERT(avio_open(&format->pb, path.c_str(), AVIO_FLAG_WRITE) >= 0);
  POSECOACH_ASSERT(avformat_write_header(format, nullptr) >= 0);
  for (std::size_t i = 0; i < film.pictures.size(); ++i) {
    const bool is_last = i + 1 == film.pictures.size();
    write_picture(*format, *encoder, film.pictures[i], film.times_ms[i],
                  is_last ? 40 : film.times_ms[i + 1] - film.times_ms[i]);
  }
  av_write_trailer(format);
  avio_closep(&format->pb);
  avcodec_free_context(&encoder);
  avformat_free_context(format);
}

void write_silence(const std::filesystem::path& path) {
  const auto number = [](std::uint32_t value, std::size_t bytes) {
    return std::string(reinterpret_cast<const char*>(&value), bytes);
  };
  const std::string samples(16000, '\0');
  const std::string format =
      number(1, 2) + number(1, 2) + number(8000, 4) + number(16000, 4) + number(2, 2) + number(16, 2);
  const std::string body = "WAVEfmt " + number(16, 4) + format + "data" + number(16000, 4) + samples;
  const auto written =
      write_file_atomically(path, "RIFF" + number(static_cast<std::uint32_t>(body.size()), 4) + body);
  POSECOACH_ASSERT(written.has_value());
}

Image make_test_picture(int width, int height, unsigned number) {
  std::mt19937 random(number + 1);
  Image image = Image::black(width, height);
  for (auto& value : image.rgb) value = static_cast<std::uint8_t>(random() & 255U);
  return image;
}

}  // namespace posecoach
